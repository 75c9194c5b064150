# A manual page of each program, made of what its --help says.
find_program(HELP2MAN help2man REQUIRED)
find_program(GZIP gzip REQUIRED)
mark_as_advanced(HELP2MAN GZIP)

set(about_gcpw_pair "stitch two photographs that no single homography aligns")
set(about_gcpw_stitch "stitch a panorama of photographs taken a step apart")
set(about_gcpw_evaluate "compare methods of image stitching on pairs of photographs")
set(pages "")
foreach(program IN LISTS programs)
    set(page "${CMAKE_CURRENT_BINARY_DIR}/${program}.1")
    add_custom_command(OUTPUT "${page}.gz"
        COMMAND "${HELP2MAN}" --no-info --no-discard-stderr "--name=${about_${program}}" --version-string=${PROJECT_VERSION}
            "--include=${CMAKE_CURRENT_SOURCE_DIR}/manuals.h2m" "--output=${page}" "$<TARGET_FILE:${program}>"
        COMMAND "${GZIP}" -9nf "${page}"
        DEPENDS ${program} manuals.h2m VERBATIM)
    list(APPEND pages "${page}.gz")
endforeach()
add_custom_target(manuals ALL DEPENDS ${pages})
install(FILES ${pages} DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tools)
