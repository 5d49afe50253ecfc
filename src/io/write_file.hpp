// Writes whole files so that the final name holds either the old bytes or all of the new ones, never a part.
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace frit::io {

// Owns an open file of the operating system.
class FileDescriptor {
 public:
  explicit FileDescriptor(int handle = -1) : handle_(handle) {}
  FileDescriptor(FileDescriptor&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~FileDescriptor() { close(); }

  bool is_open() const { return handle_ >= 0; }
  int get() const { return handle_; }
  // False, with errno set, if the system reports that earlier writes were lost.
  bool close();

 private:
  int handle_;
};

// Throws MachineError: the path, what was being done ("writing 120 bytes"), the system's reason, what to do.
[[noreturn]] void throw_machine_error(const std::filesystem::path& path, std::string_view action,
                                      int system_error);

// Writes all bytes to an open file, through interruptions and short writes. MachineError names `path`.
void write_all(const FileDescriptor& file, std::string_view bytes, const std::filesystem::path& path);

// Puts `bytes` under `path`: a new file beside it, flushed to disk, moved into place, folder flushed.
// On MachineError the path keeps what it held before and the new file is removed.
void write_file_whole(const std::filesystem::path& path, std::string_view bytes);

// The same, and what `path` held before is afterwards under `previous` in the same folder. At every moment
// one of the two names holds the old bytes, or `path` the new ones.
void write_file_keeping(const std::filesystem::path& path, const std::filesystem::path& previous,
                        std::string_view bytes);

}  // namespace frit::io
