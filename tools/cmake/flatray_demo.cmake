# cmake --build build/release --target demo: renders the demo sequence into out/demo.
if(TARGET flatray)
  add_custom_target(demo
    COMMAND flatray render scenes/demo.toml -o "out/demo/frame_####.png"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "Rendering scenes/demo.toml into out/demo"
    USES_TERMINAL VERBATIM)
else()
  add_custom_target(demo COMMENT "The command line is not part of this build: no demo")
endif()
