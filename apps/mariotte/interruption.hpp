// SIGINT and SIGTERM as a wish to end soon instead of a death.
#pragma once

namespace mariotte::command {

/// From now on the first SIGINT or SIGTERM is only noted. A later one kills as usual; one that comes at once
/// is the same wish, sent to a process and to its group.
void await_interruption();

/// The signal that came, or 0.
int interruption();

}  // namespace mariotte::command
