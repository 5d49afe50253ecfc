#include "io/write_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "core/error.hpp"

namespace frit::io {

namespace {

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

std::string advice_for(const std::filesystem::path& path, int system_error) {
  switch (system_error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "free some disk space or write to another disk";
    case ENOENT:
    case ENOTDIR:
      return fmt::format("create the folder '{}' first", folder_of(path).string());
    case EACCES:
    case EPERM:
    case EROFS:
      return fmt::format("check the permissions of '{}'", folder_of(path).string());
    case EISDIR:
      return "choose the name of a file";
    case ENAMETOOLONG:
      return "choose a shorter name";
    default:
      return "check the disk and try again";
  }
}

// A file that is removed again unless it has been moved into place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) : target_(target) {
    constexpr int most_tries = 100;  // names left behind by killed processes of the same number
    for (int attempt = 0; attempt < most_tries && !file_.is_open(); ++attempt) {
      path_ =
          folder_of(target) / fmt::format(".{}.{}-{}.tmp", target.filename().string(), ::getpid(), attempt);
      file_ = FileDescriptor(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
      if (!file_.is_open() && errno != EEXIST) break;
    }
    if (!file_.is_open()) throw_machine_error(target_, "creating a file beside it", errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!moved_) ::unlink(path_.c_str());
  }

  void write(std::string_view bytes) {
    write_all(file_, bytes, target_);
    if (::fsync(file_.get()) != 0) throw_machine_error(target_, "flushing the file to disk", errno);
    if (!file_.close()) throw_machine_error(target_, "closing the file", errno);
  }

  void move_into_place() {
    if (std::rename(path_.c_str(), target_.c_str()) != 0) {
      throw_machine_error(target_, "moving the finished file into place", errno);
    }
    moved_ = true;
  }

 private:
  std::filesystem::path target_, path_;
  FileDescriptor file_;
  bool moved_ = false;
};

// Only then does the new name survive a power failure.
void flush_folder(const std::filesystem::path& path) {
  FileDescriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.is_open()) throw_machine_error(path, "opening its folder", errno);
  const bool flushed = ::fsync(folder.get()) == 0;
  // Some network file systems cannot flush a folder and say EINVAL.
  if (!flushed && errno != EINVAL) throw_machine_error(path, "flushing its folder to disk", errno);
}

// Renaming over a device or pipe would replace it by a plain file.
void refuse_special_file(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return;
  if (S_ISDIR(status.st_mode)) throw_machine_error(path, "writing the file", EISDIR);
  throw MachineError(
      fmt::format("{}: writing the file failed: it is a device or a pipe; choose the name of a plain file",
                  path.string()));
}

}  // namespace

bool FileDescriptor::close() {
  const int handle = std::exchange(handle_, -1);
  // On Linux the handle is gone even after EINTR; closing twice could close somebody else's file.
  return handle < 0 || ::close(handle) == 0 || errno == EINTR;
}

void throw_machine_error(const std::filesystem::path& path, std::string_view action, int system_error) {
  throw MachineError(fmt::format("{}: {} failed: {}; {}", path.string(), action, std::strerror(system_error),
                                 advice_for(path, system_error)));
}

void write_all(const FileDescriptor& file, std::string_view bytes, const std::filesystem::path& path) {
  const auto total = bytes.size();
  while (!bytes.empty()) {
    const auto written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_machine_error(path, fmt::format("writing {} bytes", total), errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void write_file_whole(const std::filesystem::path& path, std::string_view bytes) {
  refuse_special_file(path);
  TemporaryFile temporary(path);
  temporary.write(bytes);
  temporary.move_into_place();
  flush_folder(path);
}

void write_file_keeping(const std::filesystem::path& path, const std::filesystem::path& previous,
                        std::string_view bytes) {
  refuse_special_file(path);
  TemporaryFile temporary(path);
  temporary.write(bytes);
  if (std::rename(path.c_str(), previous.c_str()) != 0 && errno != ENOENT) {
    throw_machine_error(previous, "keeping the previous file under this name", errno);
  }
  temporary.move_into_place();
  flush_folder(path);
}

}  // namespace frit::io
