# Writes OUT, a C++ source with the files SCRIPT and STYLE as string literals (empty where no file is given).
foreach(part SCRIPT STYLE)
  set(text "")
  if(${part})
    file(READ ${${part}} text)
  endif()
  set(${part}_TEXT "${text}")
endforeach()
file(WRITE ${OUT} "#include \"report/page_asset.hpp\"

namespace frit::report {
const std::string_view page_script = R\"~page~(${SCRIPT_TEXT})~page~\";
const std::string_view page_style = R\"~page~(${STYLE_TEXT})~page~\";
}  // namespace frit::report
")
