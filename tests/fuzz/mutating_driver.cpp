// Runs a fuzz target without libFuzzer: every file of the corpus as it is, then a fixed number of mutations
// of them, the same ones in every run. An input that breaks something, or takes over half a minute, is left
// in
// "<program>.crash" in the working directory.
//
//   fuzz_bvh CORPUS_FOLDER [MUTATIONS]
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz_target.h"

namespace {

constexpr int kMutations = 4000;
constexpr unsigned kLongest_s = 30;
constexpr std::size_t kLargestInput = 1 << 16;

// For the signal handler: plain values only.
const char* crash_data = nullptr;
std::size_t crash_size = 0;
char crash_path[4096] = {};

void save_input(int signal_number) {
  const int file = ::open(crash_path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0) {
    [[maybe_unused]] const ssize_t written = ::write(file, crash_data, crash_size);
    ::close(file);
  }
  ::signal(signal_number, SIG_DFL);
  ::raise(signal_number);
}

void run(const std::string& input) {
  crash_data = input.data();
  crash_size = input.size();
  ::alarm(kLongest_s);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
  ::alarm(0);
}

class Mutator {
 public:
  explicit Mutator(std::vector<std::string> corpus) : corpus_(std::move(corpus)) {}

  std::string next() {
    std::string text = pick(corpus_);
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes; ++i) change(text);
    if (text.size() > kLargestInput) text.resize(kLargestInput);
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }
  template <typename T>
  const T& pick(const std::vector<T>& all) {
    return all[below(all.size())];
  }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length =
        std::min(below(2) == 0 ? below(8) + 1 : below(text.size() + 1), text.size() - at);
    switch (below(10)) {
      case 0:  // a bit
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ 1 << below(8));
        break;
      case 1:  // a byte
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(at, length));
        break;
      case 4:
        text.resize(at);
        break;
      case 5:  // a part of another file
      {
        const std::string& other = pick(corpus_);
        const std::size_t from = below(other.size() + 1);
        text.insert(at, other.substr(from, below(64)));
        break;
      }
      case 6:
        text.insert(at, token());
        break;
      default:  // a whole word becomes another: what text formats are most sensitive to
        replace_word(text, at);
        break;
    }
  }

  void replace_word(std::string& text, std::size_t at) {
    constexpr const char* kEnds = " \t\r\n{}[],:\"";
    const std::size_t begin = text.find_first_not_of(kEnds, at);
    if (begin == std::string::npos) return;
    const std::size_t end = std::min(text.find_first_of(kEnds, begin), text.size());
    if (below(2) == 0) {
      text.replace(begin, end - begin, token());
      return;
    }
    const std::size_t other = text.find_first_not_of(kEnds, below(text.size()));
    if (other == std::string::npos) return;
    text.replace(begin, end - begin,
                 text.substr(other, std::min(text.find_first_of(kEnds, other), text.size()) - other));
  }

  std::string token() {
    static const std::vector<std::string> kTokens = {"0",         "-1",         "1",
                                                     "0.5",       "1e308",      "-1e308",
                                                     "1e-320",    "1e7",        "nan",
                                                     "inf",       "4294967296", "65536",
                                                     "100000000", "-",          "{",
                                                     "}",         "[",          "]",
                                                     "\"",        ",",          ":",
                                                     "\n",        "\t",         " ",
                                                     "#",         "null",       "true",
                                                     "(",         "rx",         "End Site {\n",
                                                     "JOINT x {", "\\u0000",    std::string(1, '\0'),
                                                     "\xFF"};
    return pick(kTokens);
  }

  std::vector<std::string> corpus_;
  std::mt19937_64 random_{20240611};
};

void limit_memory() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  constexpr rlim_t kBytes = rlim_t{1} << 30;
  const rlimit limit{kBytes, kBytes};
  ::setrlimit(RLIMIT_AS, &limit);
#endif
}

std::vector<std::string> read_corpus(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> corpus;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return corpus;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: " << argv[0] << " CORPUS_FOLDER [MUTATIONS]\n";
    return 2;
  }
  const std::vector<std::string> corpus = read_corpus(argv[1]);
  if (corpus.empty()) {
    std::cerr << argv[1] << ": the corpus is empty\n";
    return 1;
  }
  const std::string path = std::filesystem::path(argv[0]).filename().string() + ".crash";
  path.copy(crash_path, sizeof crash_path - 1);
  limit_memory();
  for (const int signal_number : {SIGABRT, SIGSEGV, SIGALRM, SIGFPE, SIGBUS, SIGILL})
    ::signal(signal_number, save_input);
  const int mutations = argc > 2 ? std::atoi(argv[2]) : kMutations;
  for (const std::string& input : corpus) run(input);
  Mutator mutator(corpus);
  for (int i = 0; i < mutations; ++i) run(mutator.next());
  std::cout << corpus.size() << " files and " << mutations << " mutations of them\n";
  return 0;
}
