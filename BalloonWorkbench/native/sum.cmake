# SPDX-License-Identifier: LGPL-2.1-or-later
# cmake -DLIBRARY=FILE -P sum.cmake: the file's SHA-256 sum into FILE.sha256, as sha256sum writes it.
file(SHA256 "${LIBRARY}" digest)
get_filename_component(name "${LIBRARY}" NAME)
file(WRITE "${LIBRARY}.sha256" "${digest}  ${name}\n")
