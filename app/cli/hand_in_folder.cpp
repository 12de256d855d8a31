#include "app/cli/hand_in_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "app/cli/commands/foreign_program.h"
#include "app/cli/message.h"
#include "pipeline/export/buffers/byte_file.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds kBuild{60};

class Folder {
public:
    Folder() {
        std::error_code failed;
        std::string name = (fs::temp_directory_path(failed) / "shadescope-XXXXXX").string();
        if (!failed && ::mkdtemp(name.data())) m_path = name;
    }
    ~Folder() {
        std::error_code ignored;
        if (!m_path.empty()) fs::remove_all(m_path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const fs::path& path() const { return m_path; }  // empty where none could be made

private:
    fs::path m_path;
};

pipeline::Result<std::monostate> copyInto(const fs::path& folder, const lessons::HandInFiles::OfTask& files) {
    for (const auto& [name, bytes] : files.bytes) {
        std::error_code failed;
        fs::create_directories((folder / name).parent_path(), failed);
        pipeline::ByteFile file(folder / name);
        file.write(bytes);
        if (const auto written = file.close(); !written) return written.errors();
        if (files.executable.contains(name))
            fs::permissions(folder / name, fs::perms::owner_exec, fs::perm_options::add, failed);
    }
    return std::monostate();
}

}  // namespace

lessons::OpensHandIn opensHandIn(const lessons::Course& course, const pipeline::Stop& stop) {
    return [&course, stop](const lessons::HandInFiles::OfTask& files) -> pipeline::Result<lessons::RunsCommand> {
        const auto folder = std::make_shared<const Folder>();
        if (folder->path().empty())
            return pipeline::Error{
                {}, "could not make a temporary folder: " + std::generic_category().message(errno), {}};
        if (const auto copied = copyInto(folder->path(), files); !copied) return copied.errors();
        return lessons::RunsCommand([&course, stop, folder](const std::string& command, const std::string& input) {
            ProgramLimits limits;
            limits.time = std::chrono::seconds(course.seconds);
            if (input.empty()) limits.time = std::max<std::chrono::milliseconds>(limits.time, kBuild);
            limits.folder = folder->path().string();
            const std::string whole = course.confine.empty() ? command : course.confine + " sh -c " + inShell(command);
            return runProgram(whole, input, limits, stop);
        });
    };
}

void tellOfPrograms(const lessons::Course& course) {
    if (!course.runsPrograms() || !course.confine.empty()) return;
    tell(
        "This runs the programs of the hand-ins. They are limited to {} s and 64 MB of output, and not confined: they "
        "can read "
        "your files and use the network. This line in the course's file confines them:\n"
        "confine = \"bwrap --ro-bind / / --dev /dev --proc /proc --tmpfs /tmp --tmpfs $HOME --bind $PWD $PWD --chdir "
        "$PWD "
        "--unshare-all --die-with-parent\"\n",
        course.seconds);
}

}  // namespace app
