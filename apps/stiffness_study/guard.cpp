#include "guard.hpp"

#include <fmt/format.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace mariotte::stiffness_study {
namespace {

using Json = nlohmann::json;

std::string packed(const Run& run) {
  Json icr = Json::array();
  for (const auto& ratio : run.icr) icr.push_back(ratio ? Json(*ratio) : Json());
  return Json{{"ending", run.ending},    {"reason", run.reason},     {"admitted", run.admitted},
              {"flows", run.flows},      {"steps", run.steps},       {"rhs", run.rhs},
              {"seconds", run.seconds},  {"velocity", run.velocity}, {"icr", icr},
              {"instants", run.instants}}
      .dump();
}

Run unpacked(const Json& json) {
  Run run{.ending = json["ending"], .reason = json["reason"], .admitted = json["admitted"]};
  run.flows = json["flows"];
  run.steps = json["steps"];
  run.rhs = json["rhs"];
  run.seconds = json["seconds"];
  run.velocity = json["velocity"].get<std::vector<double>>();
  for (const auto& ratio : json["icr"])
    run.icr.push_back(ratio.is_null() ? std::nullopt : std::optional(ratio.get<double>()));
  run.instants = json["instants"].get<std::vector<double>>();
  return run;
}

// The signal of an expired timer ends the process.
void limit_cpu_time(double seconds) {
  const auto whole = static_cast<time_t>(seconds);
  const itimerval timer{
      .it_interval = {},
      .it_value = {whole, static_cast<suseconds_t>(1e6 * (seconds - static_cast<double>(whole)))}};
  std::signal(SIGPROF, SIG_DFL);
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

[[noreturn]] void child(const ImpactCase& one, const Request& request, double limit, int out) {
  limit_cpu_time(limit);
  const std::string text = packed(measure(one, request));
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = ::write(out, text.data() + sent, text.size() - sent);
    if (count < 0 && errno != EINTR) ::_exit(1);
    if (count > 0) sent += static_cast<std::size_t>(count);
  }
  ::_exit(0);
}

std::string read_all(int in) {
  std::string text;
  char buffer[4096];
  for (;;) {
    const ssize_t count = ::read(in, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(count));
  }
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return status;
}

}  // namespace

Run guarded(const ImpactCase& one, const Request& request, double limit) {
  int ends[2];
  if (::pipe(ends) != 0) return measure(one, request);
  const pid_t process = ::fork();
  if (process == 0) child(one, request, limit, ends[1]);
  ::close(ends[1]);
  const std::string text = process > 0 ? read_all(ends[0]) : "";
  ::close(ends[0]);
  if (process < 0) return measure(one, request);
  const int status = wait_for(process);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return unpacked(Json::parse(text));
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF)
    return {.ending = "-", .reason = fmt::format("took more than {:g} s", limit)};
  return {.ending = "failed", .reason = "its process died"};
}

}  // namespace mariotte::stiffness_study
