// How a run shows its progress: a line that renews itself, plain lines, or JSON lines.
#pragma once

#include <memory>

#include "run/listener.hpp"

namespace frit::app {

enum class Display { bar, lines, json, quiet };

// bar: on a terminal, several times a second; lines: one per output; json: one object per line; quiet:
// nothing.
std::unique_ptr<run::RunListener> make_display(Display display);

}  // namespace frit::app
