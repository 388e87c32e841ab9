// SIGINT and SIGTERM as a wish to end soon instead of a death.
#pragma once

namespace mariotte::command {

/// From now on the first SIGINT or SIGTERM is only noted; a second one kills as usual.
void await_interruption();

/// The signal that came, or 0.
int interruption();

}  // namespace mariotte::command
