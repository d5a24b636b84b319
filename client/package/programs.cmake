# The programs by themselves (cmake --install BUILD --component programs), for an image that needs no libraries, with their
# manual pages and what completes their arguments in a shell. Both are made by the programs from their own arguments.
install(TARGETS goniod gonio RUNTIME COMPONENT programs)

set(made ${CMAKE_CURRENT_BINARY_DIR}/made)
set(gonio "'$<TARGET_FILE:gonio>'")
set(goniod "'$<TARGET_FILE:goniod>'")
add_custom_command(
  OUTPUT ${made}/complete
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${made}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${made}/bash ${made}/fish ${made}/zsh
  COMMAND gonio man -o ${made}/man1
  COMMAND sh -c "${goniod} --man-page >'${made}/man1/goniod.1'"
  COMMAND sh -c "${gonio} completion bash >'${made}/bash/gonio' && ${goniod} --completion bash >'${made}/bash/goniod'"
  COMMAND sh -c "${gonio} completion zsh >'${made}/zsh/_gonio' && ${goniod} --completion zsh >'${made}/zsh/_goniod'"
  COMMAND sh -c "${gonio} completion fish >'${made}/fish/gonio.fish' && ${goniod} --completion fish >'${made}/fish/goniod.fish'"
  COMMAND ${CMAKE_COMMAND} -E touch ${made}/complete
  DEPENDS gonio goniod
  COMMENT "Manual pages and completion" VERBATIM)
add_custom_target(gonio_pages ALL DEPENDS ${made}/complete)

# Where only the programs' targets were built, there are none.
foreach(place "man1 ${CMAKE_INSTALL_MANDIR}" "bash ${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
              "zsh ${CMAKE_INSTALL_DATADIR}/zsh/site-functions" "fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
  separate_arguments(place)
  list(GET place 0 from)
  list(GET place 1 to)
  if(from STREQUAL "man1")
    set(to ${to}/man1)
  endif()
  install(DIRECTORY ${made}/${from}/ DESTINATION ${to} COMPONENT programs OPTIONAL)
endforeach()
