# SPDX-License-Identifier: MIT
# Writes OUTPUT, the C++ table of the files in FOLDER (runtime/page/templates.h):
#   cmake -DFOLDER=... -DOUTPUT=... -P embed.cmake
file(GLOB files ${FOLDER}/*)
list(SORT files)
set(text "// Written by runtime/page/embed.cmake.\n#include \"page/templates.h\"\n\nnamespace strobe::page {\n\n")
string(APPEND text "static const EmbeddedFile kFiles[] = {\n")
foreach(file ${files})
  get_filename_component(name ${file} NAME)
  file(READ ${file} content)
  string(APPEND text "    {\"${name}\", R\"embedded(${content})embedded\"},\n")
endforeach()
string(APPEND text "};\n\nstd::span<const EmbeddedFile> embeddedFiles() { return kFiles; }\n\n}  // namespace strobe::page\n")
file(WRITE ${OUTPUT} "${text}")
