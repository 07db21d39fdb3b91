// What the program remembers between runs. Apart from the window's model, whose words for cameras are others.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

namespace posecoach {

struct Remembered {
  std::string source;         // the camera, as open_source() takes it; empty: none was chosen
  int width = 0, height = 0;  // of its pictures; 0: the program chooses
  double fps = 0;
  std::string format;
  std::string theme = "dark", palette = "red-green";
  double text_size = 1;
  bool is_sound_on = true;
  std::string person;
  std::map<std::string, std::string> keys;  // as the settings name them
};

class Memory {
 public:
  explicit Memory(const std::filesystem::path& file);
  ~Memory();
  const std::string& message() const;  // what was wrong with the file

  Remembered remembered;
  void save();

 private:
  class File;
  std::unique_ptr<File> file_;
};

}  // namespace posecoach
