# Installs the interfaces of the build folder LMS3D_BUILD into LMS3D_FOLDER, and builds a client there
# with LMS3D_GENERATOR.

set(prefix "${LMS3D_FOLDER}/prefix")
file(REMOVE_RECURSE "${LMS3D_FOLDER}")
foreach (command IN ITEMS
    "${CMAKE_COMMAND};--install;${LMS3D_BUILD}/Plugins/CORBA/IDL;--prefix;${prefix};--component;development"
    "${CMAKE_COMMAND};-S;${CMAKE_CURRENT_LIST_DIR};-B;${LMS3D_FOLDER}/build;-G;${LMS3D_GENERATOR};-DCMAKE_PREFIX_PATH=${prefix}"
    "${CMAKE_COMMAND};--build;${LMS3D_FOLDER}/build")
  execute_process(COMMAND ${command} RESULT_VARIABLE code)
  if (NOT code EQUAL 0)
    list(JOIN command " " words)
    message(FATAL_ERROR "This failed: ${words}")
  endif ()
endforeach ()
