#include "io/write_file.hpp"

#include <sys/resource.h>
#include <csignal>

#include "temporary_folder.hpp"

namespace frit::io {
namespace {

// No file of this process may grow beyond `bytes` while this lives: a full disk without being root.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(WriteFile, ReplacesTheWholeFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {std::string("first, longer"), std::string("second"), std::string()}) {
    write_file_whole(folder / "a.txt", bytes);
    EXPECT_EQ(bytes_of(folder / "a.txt"), bytes);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
  }
}

TEST(WriteFile, BytesPassUnchanged) {
  const TemporaryFolder folder;
  std::string bytes(3'000'000, '\0');
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * k >> 3);
  write_file_whole(folder / "b.bin", bytes);
  EXPECT_EQ(bytes_of(folder / "b.bin"), bytes);
}

TEST(WriteFile, NameWithoutFolderMeansTheWorkingFolder) {
  const TemporaryFolder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  write_file_whole("plain.txt", "x");
  std::filesystem::current_path(before);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"plain.txt"});
}

TEST(WriteFile, FullDiskKeepsTheOldFileAndSaysWhatToDo) {
  const TemporaryFolder folder;
  const auto path = folder.write("c.txt", "old");
  const auto message = message_of<MachineError>([&] {
    const FileSizeLimit limit(4096);
    write_file_whole(path, std::string(10000, 'x'));
  });
  EXPECT_EQ(message, path.string() +
                         ": writing 10000 bytes failed: File too large; "
                         "free some disk space or write to another disk");
  EXPECT_EQ(bytes_of(path), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"c.txt"});
}

TEST(WriteFile, MissingFolderIsNamed) {
  const TemporaryFolder folder;
  const auto path = folder / "none/d.txt";
  EXPECT_EQ(message_of<MachineError>([&] { write_file_whole(path, "x"); }),
            path.string() +
                ": creating a file beside it failed: No such file or directory; create the folder '" +
                path.parent_path().string() + "' first");
}

TEST(WriteFile, DevicesAndFoldersAreNotReplaced) {
  EXPECT_EQ(message_of<MachineError>([] { write_file_whole("/dev/full", "x"); }),
            "/dev/full: writing the file failed: it is a device or a pipe; choose the name of a plain file");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  EXPECT_EQ(
      message_of<MachineError>([&] { write_file_whole(folder / "sub", "x"); }),
      (folder / "sub").string() + ": writing the file failed: Is a directory; choose the name of a file");
}

TEST(WriteFile, TooLongANameIsAMachineError) {
  const TemporaryFolder folder;
  const auto message =
      message_of<MachineError>([&] { write_file_whole(folder / std::string(255, 'n'), "x"); });
  EXPECT_NE(message.find("File name too long; choose a shorter name"), message.npos) << message;
}

TEST(WriteFile, ForeignFilesOfOurTemporaryNameAreNotTouched) {
  const TemporaryFolder folder;
  const auto foreign = ".e.txt." + std::to_string(::getpid()) + "-0.tmp";
  folder.write(foreign, "foreign");
  write_file_whole(folder / "e.txt", "mine");
  EXPECT_EQ(bytes_of(folder / "e.txt"), "mine");
  EXPECT_EQ(bytes_of(folder / foreign), "foreign");
}

}  // namespace
}  // namespace frit::io
