// The page's script and style, bundled from web/ when frit is built (cmake/page_asset.cmake); empty without a
// bundler.
#pragma once

#include <string_view>

namespace frit::report {

extern const std::string_view page_script, page_style;

}  // namespace frit::report
