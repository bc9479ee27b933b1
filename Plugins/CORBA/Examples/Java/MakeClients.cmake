# Makes the clients in Java from LMS3D_SOURCE, with all of Maven's files in LMS3D_FOLDER.

set(advice "  To do without the clients in Java: cmake --preset default -DLMS3D_TEST_JAVA_CLIENTS=OFF\n")

find_program(maven mvn)
if (NOT maven)
  message(FATAL_ERROR "There is no Maven (mvn) on this machine.\n${advice}")
endif ()
execute_process(
  COMMAND "${maven}" --batch-mode --quiet package
    --file "${LMS3D_SOURCE}/pom.xml"
    "-Dmaven.repo.local=${LMS3D_FOLDER}/repository"
    "-Dlms3d.build=${LMS3D_FOLDER}"
  RESULT_VARIABLE code)
if (NOT code EQUAL 0)
  message(FATAL_ERROR
    "Maven could not make the clients in Java. It needs a JDK of Java 11 or newer and, the first time, "
    "a Maven repository such as settings.xml names.\n${advice}")
endif ()
