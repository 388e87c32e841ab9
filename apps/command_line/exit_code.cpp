#include "command_line/exit_code.hpp"

#include <new>
#include <system_error>

#include "command_line/terminal.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/study/journal/journal.hpp"

namespace mariotte::command {
namespace {

int fail(const char* message, Fault fault, ExitCode code) {
  error(message, fault);
  return code;
}

int fail(const Error& problem, ExitCode code) {
  return fail(problem.what(), problem.fault, code);
}

}  // namespace

ExitCode exit_code(hybrid::Ending ending) {
  switch (ending) {
    case hybrid::Ending::separated:
    case hybrid::Ending::captured:
    case hybrid::Ending::bound:
      return ExitCode::ok;
    case hybrid::Ending::time_limit:
    case hybrid::Ending::event_limit:
    case hybrid::Ending::interrupted:
      return ExitCode::limit;
    case hybrid::Ending::unsure:
    case hybrid::Ending::invalid:
    case hybrid::Ending::failed:
      return ExitCode::solver_failed;
  }
  return ExitCode::solver_failed;
}

Fault fault_of(hybrid::Ending ending) {
  if (ending == hybrid::Ending::invalid) return fault::invalid;
  return exit_code(ending) == ExitCode::limit ? fault::limit : fault::stopped;
}

int guarded(const std::function<int()>& action) noexcept {
  try {
    return action();
  } catch (const ReaderGone&) {
    return ExitCode::bad_file;
  } catch (const UsageError& problem) {
    return fail(problem, ExitCode::usage);
  } catch (const scene::SceneError& problem) {
    fail(problem, ExitCode::bad_scene);
    for (const auto& other : problem.more) fail(other, ExitCode::bad_scene);
    return ExitCode::bad_scene;
  } catch (const InvalidParameter& problem) {
    return fail(problem, ExitCode::bad_scene);
  } catch (const scene::FileError& problem) {
    return fail(problem, ExitCode::bad_file);
  } catch (const study::JournalError& problem) {
    return fail(problem, ExitCode::bad_file);
  } catch (const report::FileError& problem) {
    return fail(problem, ExitCode::bad_file);
  } catch (const std::system_error& problem) {
    return fail(problem.what(), fault::unwritable, ExitCode::bad_file);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", fault::stopped, ExitCode::solver_failed);
  } catch (const Error& problem) {
    return fail(problem, ExitCode::solver_failed);
  } catch (const std::exception& problem) {
    return fail(problem.what(), fault::stopped, ExitCode::solver_failed);
  }
}

}  // namespace mariotte::command
