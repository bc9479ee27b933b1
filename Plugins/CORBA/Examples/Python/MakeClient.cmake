# Creates in LMS3D_FOLDER what the client with omniORBpy needs: environment/, a virtual environment of
# LMS3D_PYTHON, and stubs/, compiled from the files in LMS3D_IDL.

set(environment "${LMS3D_FOLDER}/environment")
set(stubs "${LMS3D_FOLDER}/stubs")
file(MAKE_DIRECTORY "${stubs}")
foreach (command IN ITEMS
    "${LMS3D_PYTHON};-m;venv;--clear;${environment}"
    "${environment}/bin/pip;install;--quiet;--disable-pip-version-check;--requirement;${LMS3D_SOURCE}/requirements.txt"
    "${environment}/bin/python;${environment}/bin/omniidl;-bpython;-C${stubs};${LMS3D_IDL}/LMS3D.idl;${LMS3D_IDL}/LMS3DScanner.idl")
  execute_process(COMMAND ${command} RESULT_VARIABLE code)
  if (NOT code EQUAL 0)
    list(JOIN command " " words)
    message(FATAL_ERROR
      "This failed: ${words}\n  It needs Python's venv and, the first time, a Python package "
      "index.\n  To leave the client out: cmake --preset default -DLMS3D_TEST_OMNIORBPY_CLIENT=OFF\n")
  endif ()
endforeach ()
