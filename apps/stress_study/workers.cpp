#include "workers.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

#include "verdict_text.hpp"

namespace mariotte::stress_study {
namespace {

/// A scene to examine, perhaps without the runs that have taken too long before.
struct Order {
  std::uint64_t scene = 0, spare = 0;
};

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// All of it, whatever signals come; false at the end of the file.
bool read_all(int file, void* to, std::size_t size) {
  for (auto* at = static_cast<char*>(to); size > 0;) {
    const auto got = ::read(file, at, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool write_all(int file, const void* from, std::size_t size) {
  for (const auto* at = static_cast<const char*>(from); size > 0;) {
    const auto put = ::write(file, at, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    at += put;
    size -= static_cast<std::size_t>(put);
  }
  return true;
}

/// What a worker is doing, for the process that outlives it.
struct Note {
  char text[128];
};

void allow_seconds(double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds)));
  ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

[[noreturn]] void work(const Campaign& campaign, int orders, int results, Note& note) noexcept {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGVTALRM}) ::signal(signal, SIG_DFL);
  const auto announce = [&](const std::string& what) {
    std::strncpy(note.text, what.c_str(), sizeof note.text - 1);
    allow_seconds(campaign.patience);
  };
  for (Order order; read_all(orders, &order, sizeof order);) {
    const auto text = packed(examine(campaign.families, campaign.seed, order.scene, announce,
                                     {.spare = order.spare != 0, .brisk = campaign.brisk}));
    allow_seconds(0);
    const std::uint64_t size = text.size();
    if (!write_all(results, &size, sizeof size) || !write_all(results, text.data(), text.size())) break;
  }
  ::_exit(0);
}

class Worker {
 public:
  explicit Worker(const Campaign& campaign) : campaign_(campaign) {
    void* page = ::mmap(nullptr, sizeof(Note), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (page == MAP_FAILED) fail("mmap");
    note_ = static_cast<Note*>(page);
    start();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    ::kill(process_, SIGKILL);
    leave();
    ::munmap(note_, sizeof(Note));
  }

  int results() const { return results_; }
  bool busy() const { return order_.has_value(); }
  void take_order(const Order& order) {
    order_ = order;
    write_all(orders_, &order, sizeof order);  // a worker that is gone is noticed by its results
  }
  /// The verdict that is ready, or that on a worker that died over its scene; empty if it tries again.
  std::optional<Verdict> take() {
    std::uint64_t size = 0;
    std::string text;
    if (read_all(results_, &size, sizeof size)) text.resize(size);
    if (text.empty() || !read_all(results_, text.data(), size)) return bury();
    order_.reset();
    return unpacked(text);
  }

 private:
  void start() {
    int orders[2], results[2];
    if (::pipe(orders) != 0 || ::pipe(results) != 0) fail("pipe");
    process_ = ::fork();
    if (process_ < 0) fail("fork");
    if (process_ == 0) {
      ::close(orders[1]);
      ::close(results[0]);
      work(campaign_, orders[0], results[1], *note_);
    }
    ::close(orders[0]);
    ::close(results[1]);
    orders_ = orders[1];
    results_ = results[0];
  }
  int leave() {
    int status = 0;
    ::waitpid(process_, &status, 0);
    ::close(orders_);
    ::close(results_);
    return status;
  }
  std::optional<Verdict> bury() {
    const int status = leave();
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    const bool late = signal == SIGVTALRM;
    const Order order = *order_;
    start();
    const std::string_view run = note_->text;
    if (late && order.spare == 0 && (run.ends_with(perturbed_mark) || !run.starts_with("auto"))) {
      take_order({order.scene, 1});
      return {};
    }
    order_.reset();
    Verdict verdict{.scene = order.scene, .error = {-1, -1, -1}};
    verdict.killed = late;
    verdict.failures = !late;
    verdict.findings = {late ? fmt::format("{}: no end after {} s", note_->text, campaign_.patience)
                             : fmt::format("{}: the process died by signal {}", note_->text, signal)};
    return verdict;
  }

  const Campaign& campaign_;
  Note* note_;
  pid_t process_ = 0;
  int orders_ = -1, results_ = -1;
  std::optional<Order> order_;
};

}  // namespace

void examine_all(const Campaign& campaign, const std::function<bool(std::uint64_t)>& more,
                 const std::function<void(const Verdict&)>& take) {
  std::vector<std::unique_ptr<Worker>> workers;
  std::uint64_t next = campaign.first;
  const auto keep_busy = [&](Worker& worker) {
    if (more(next)) worker.take_order({.scene = next++});
  };
  for (int i = 0; i < campaign.workers; ++i) {
    workers.push_back(std::make_unique<Worker>(campaign));
    keep_busy(*workers.back());
  }
  for (;;) {
    std::vector<pollfd> waiting;
    std::vector<Worker*> whose;
    for (auto& worker : workers)
      if (worker->busy()) {
        waiting.push_back({.fd = worker->results(), .events = POLLIN, .revents = 0});
        whose.push_back(worker.get());
      }
    if (waiting.empty()) return;
    if (::poll(waiting.data(), waiting.size(), -1) < 0 && errno != EINTR) fail("poll");
    for (std::size_t i = 0; i < waiting.size(); ++i)
      if (waiting[i].revents) {
        if (const auto verdict = whose[i]->take()) take(*verdict);
        if (!whose[i]->busy()) keep_busy(*whose[i]);
      }
  }
}

}  // namespace mariotte::stress_study
