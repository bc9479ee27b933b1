# Builds the clients in Java from LMS3D_SOURCE. All of Maven's files go to LMS3D_FOLDER.

set(advice "  To leave the clients in Java out: cmake --preset default -DLMS3D_TEST_JAVA_CLIENTS=OFF\n")

find_program(maven mvn)
if (NOT maven)
  message(FATAL_ERROR "Maven (mvn) is not installed.\n${advice}")
endif ()
execute_process(
  COMMAND "${maven}" --batch-mode --quiet package
    --file "${LMS3D_SOURCE}/pom.xml"
    "-Dmaven.repo.local=${LMS3D_FOLDER}/repository"
    "-Dlms3d.build=${LMS3D_FOLDER}"
  RESULT_VARIABLE code)
if (NOT code EQUAL 0)
  message(FATAL_ERROR
    "Maven could not build the clients in Java. It needs a JDK of Java 11 or newer and, the first time, "
    "a Maven repository.\n${advice}")
endif ()
