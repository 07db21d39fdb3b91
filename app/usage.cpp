#include "app/usage.h"

#include <CLI/CLI.hpp>
#include <cstdio>

namespace posecoach {
namespace {

// A name out of a broken file may hold anything; the message stays one line.
std::string one_line(std::string message) {
  for (char& character : message)
    if (static_cast<unsigned char>(character) < ' ' || character == '\x7f') character = '?';
  return message;
}

}  // namespace

std::string usage_line(const CLI::App* cli, const CLI::Error& error) {
  std::string help = cli->get_name();
  for (const CLI::App* at = cli; !at->get_subcommands().empty();) {
    at = at->get_subcommands().front();
    help += " " + at->get_name();
  }
  return std::string("posecoach: ") + error.what() + "; try: " + help + " --help\n";
}

int fail_with(const std::string& message) {
  std::fprintf(stderr, "posecoach: %s\n", one_line(message).c_str());
  return 1;
}

}  // namespace posecoach
