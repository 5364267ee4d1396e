# Writes a C++ file that holds a table of measured paints: cmake -DOUTPUT=... -DTABLE=... -P this.
file(READ ${TABLE} text)
file(WRITE ${OUTPUT} "// Generated from ${TABLE}.\n#include \"core/optics/spectral/measured_paints.h\"\n\nnamespace pentimento {\nstd::string_view measured_paint_table() {\n  return R\"csv(${text})csv\";\n}\n}  // namespace pentimento\n")
