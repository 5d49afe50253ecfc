# The report's page (web/) as text inside the program: bundled by esbuild, Debian's if it is there, else npm's. Without
# either frit is built all the same, and `frit report` says what is missing.
set(FRIT_PAGE "AUTO" CACHE STRING "Page for reports: ON, OFF, or AUTO (where esbuild or npm is found)")

function(frit_page_asset target)
  set(web ${PROJECT_SOURCE_DIR}/web)
  set(out ${PROJECT_BINARY_DIR}/web)
  set(script "")
  set(style "")
  find_program(FRIT_ESBUILD esbuild)
  find_program(FRIT_NPM npm)
  if(FRIT_PAGE STREQUAL "OFF" OR NOT (FRIT_ESBUILD OR FRIT_NPM))
    if(FRIT_PAGE STREQUAL "ON")
      message(FATAL_ERROR "FRIT_PAGE=ON needs esbuild or npm")
    endif()
    message(STATUS "Page for reports: no (needs esbuild or npm)")
  else()
    set(script ${out}/main.js)
    set(style ${out}/main.css)
    file(GLOB sources CONFIGURE_DEPENDS ${web}/src/*.ts ${web}/src/*.css)
    set(esbuild ${FRIT_ESBUILD})
    if(NOT FRIT_ESBUILD)
      set(esbuild ${out}/node_modules/.bin/esbuild)
      add_custom_command(OUTPUT ${esbuild}
        COMMAND ${CMAKE_COMMAND} -E copy ${web}/package.json ${web}/package-lock.json ${out}
        COMMAND ${FRIT_NPM} ci --omit=dev --no-audit --no-fund --prefix ${out}
        DEPENDS ${web}/package.json ${web}/package-lock.json
        COMMENT "Getting esbuild by npm" VERBATIM)
    endif()
    add_custom_command(OUTPUT ${script} ${style}
      COMMAND ${esbuild} ${web}/src/main.ts --bundle --minify --format=iife --target=es2020 --charset=utf8
              --log-level=warning --outdir=${out}
      DEPENDS ${sources} ${esbuild}
      COMMENT "Bundling the report's page" VERBATIM)
  endif()
  set(asset ${out}/page_asset.cpp)
  add_custom_command(OUTPUT ${asset}
    COMMAND ${CMAKE_COMMAND} -D SCRIPT=${script} -D STYLE=${style} -D OUT=${asset} -P
            ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake
    DEPENDS ${script} ${style} ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake VERBATIM)
  target_sources(${target} PRIVATE ${asset})
endfunction()
