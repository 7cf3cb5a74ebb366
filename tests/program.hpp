#pragma once
/// Starts the real program as a user does: own process, exit code, both output streams, signals.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace stresslet::program {

/// A folder of its own for one test, removed with what it holds.
class Workplace {
 public:
  Workplace() {
    std::string pattern = (std::filesystem::temp_directory_path() / "stresslet-XXXXXX").string();
    if (!::mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  ~Workplace() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Outcome {
  int code = 0;  ///< exit code, or 128 + signal
  std::string out, err;
  double peak_bytes = 0;  ///< largest resident memory
};

/// What tells a file from the one that replaces it, empty where there is none.
inline std::string file_identity(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return "";
  return std::to_string(status.st_ino) + " " + std::to_string(status.st_mtim.tv_sec) + " " +
         std::to_string(status.st_mtim.tv_nsec);
}

/// A process; killed and waited for if the test leaves it running.
class Process {
 public:
  explicit Process(std::vector<std::string> command) {
    out_ = folder_ / "out", err_ = folder_ / "err";
    std::vector<char*> argv;
    for (std::string& argument : command) argv.push_back(argument.data());
    argv.push_back(nullptr);
    id_ = ::fork();
    if (id_ < 0) throw std::runtime_error("cannot fork");
    if (id_ == 0) {
      redirect(out_, STDOUT_FILENO), redirect(err_, STDERR_FILENO);
      ::execvp(argv[0], argv.data());
      ::_exit(127);
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (id_ > 0) ::kill(id_, SIGKILL), ::waitpid(id_, nullptr, 0);
  }

  void send(int signal) const { ::kill(id_, signal); }

  Outcome wait() {
    int status = 0;
    rusage usage{};
    ::wait4(id_, &status, 0, &usage);
    id_ = 0;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), content_of(out_), content_of(err_),
            1024.0 * double(usage.ru_maxrss)};
  }

  /// Waits until `condition` holds or the process has ended; returns whether it still runs.
  bool run_until(const std::function<bool()>& condition) const {
    while (!condition()) {
      siginfo_t ended{};
      ::waitid(P_PID, id_t(id_), &ended, WEXITED | WNOHANG | WNOWAIT);
      if (ended.si_pid != 0) return false;
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return true;
  }

 private:
  static void redirect(const std::string& file, int stream) {
    ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), stream);
  }

  Workplace folder_;
  std::string out_, err_;
  pid_t id_ = 0;
};

/// "--set" before each assignment.
inline std::vector<std::string> settings(const std::vector<std::string>& assignments) {
  std::vector<std::string> arguments;
  for (const std::string& assignment : assignments) arguments.insert(arguments.end(), {"--set", assignment});
  return arguments;
}

inline std::vector<std::string> stresslet_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), STRESSLET_BINARY);
  return arguments;
}

/// The program with these arguments, to its end.
inline Outcome stresslet(std::vector<std::string> arguments) {
  return Process(stresslet_command(std::move(arguments))).wait();
}

inline std::vector<std::string> run_arguments(const std::string& input, const std::string& output,
                                              const std::vector<std::string>& assignments = {}) {
  std::vector<std::string> arguments{"run", input, "--output", output, "--quiet"};
  for (const std::string& argument : settings(assignments)) arguments.push_back(argument);
  return arguments;
}

inline std::vector<std::string> restart_arguments(const std::string& output,
                                                  const std::vector<std::string>& assignments = {}) {
  std::vector<std::string> arguments{"restart", output, "--quiet"};
  for (const std::string& argument : settings(assignments)) arguments.push_back(argument);
  return arguments;
}

/// A small suspension that runs in a fraction of a second.
inline std::string small_case() {
  return R"([suspension]
solid_fraction = 0.45
count = 80
seed = 3
[contact]
friction = 0.5
[run]
strain = 0.02
average_from = 0.005
threads = 1
[output]
sample_every = 0.001
snapshot_every = 0.005
)";
}

}  // namespace stresslet::program
