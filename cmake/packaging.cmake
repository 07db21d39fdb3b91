# What `cmake --install` puts where, and the Debian package of it (`cpack -G DEB` in the build folder). The pose models
# are not ours to pass on: posecoach-fetch-models gets them for whoever installs.
set(CMAKE_INSTALL_DOCDIR share/doc/virtual-pose-coach)
include(GNUInstallDirs)
install(TARGETS posecoach RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(PROGRAMS scripts/fetch-models DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME posecoach-fetch-models)
install(FILES assets/desktop/virtual-pose-coach.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES assets/desktop/virtual-pose-coach.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES assets/desktop/virtual-pose-coach.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES LICENSE NOTICE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)

set(CPACK_PACKAGE_NAME virtual-pose-coach)
set(CPACK_PACKAGE_CONTACT "The Virtual Pose Coach authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Your coach's golf swing, in your own body")
set(CPACK_PACKAGE_DESCRIPTION "Watches a golfer through a webcam or in a film, shows the coach's motion in the golfer's own
body over the picture, and says what to change.")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What shlibdeps cannot see: the renderer behind libEGL, a BLAS that is not forty times slower, npm for fetching the models.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libgl1-mesa-dri, libopenblas0-pthread")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS npm)
include(CPack)
