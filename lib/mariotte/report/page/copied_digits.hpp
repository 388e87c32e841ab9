// What is copied from a page.
#pragma once

namespace mariotte::report {

/// A script that gives cells of tables with a title, which are numbers, all of their digits when they are
/// copied: cells of a row with tabs between them, as spreadsheets expect.
extern const char* const copied_digits;

}  // namespace mariotte::report
