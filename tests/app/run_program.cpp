#include "tests/app/run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "core/base/file.h"
#include "tests/support/temporary_folder.h"

extern char** environ;

namespace posecoach {

ProgramRun run_posecoach(const std::vector<std::string>& arguments, Interrupt interrupt,
                         const std::filesystem::path& watched) {
  const TemporaryFolder said;
  const std::string output = (said.path() / "output").string(), error = (said.path() / "error").string();
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  constexpr int kNew = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(), kNew, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, error.c_str(), kNew, 0600);
  std::vector<std::string> words = {POSECOACH_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t process = 0;
  const int failed = posix_spawn(&process, POSECOACH_PROGRAM, &files, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  EXPECT_EQ(failed, 0) << POSECOACH_PROGRAM;
  if (failed != 0) return {};
  int status = 0;
  bool has_ended = false;
  while (interrupt == Interrupt::AfterFirstFile && !has_ended && std::filesystem::is_empty(watched)) {
    ::usleep(1000);
    has_ended = ::waitpid(process, &status, WNOHANG) == process;
  }
  if (interrupt == Interrupt::AfterFirstFile && !has_ended) ::kill(process, SIGINT);
  if (!has_ended) ::waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(output).value(), read_file(error).value()};
}

}  // namespace posecoach
