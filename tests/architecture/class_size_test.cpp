// A class that knows too much has too many functions and members. Cutting it into several files does not help, so the
// class is counted, not its files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <regex>

#include "tests/architecture/source_tree.h"

namespace architecture {
namespace {

struct ClassSize {
    int functions = 0, members = 0;  // members without static ones
    bool operator==(const ClassSize&) const = default;
};
constexpr ClassSize kMost{30, 15};

// The classes that are still larger. A class leaves the list when it is small enough, and a number only falls.
const std::map<std::string, ClassSize>& largerThanMost() {
    static const std::map<std::string, ClassSize> table{
        {"app/talk/cue_model.h CueModel", {45, 10}},
        {"app/document/document.h Document", {49, 14}},
        {"app/lesson/lesson_run.h LessonRun", {33, 8}},
        {"app/document/renderer_check.h RendererCheck", {31, 17}},
        {"app/frames/stepper.h Stepper", {42, 16}},
        {"app/talk/notes_window.h NotesWindow", {19, 19}},
        {"app/export/slide_dialog.h SlideDialog", {12, 19}},
        {"app/buffer_view/buffer_header.h BufferHeader", {20, 16}},
        {"app/buffer_view/buffer_view.h BufferView", {33, 15}},
        {"app/check/check_panel.h CheckPanel", {22, 19}},
        {"app/inspector/inspector_panel.h InspectorPanel", {11, 20}},
        {"lessons/expression/parser.h Parser", {48, 11}},
        {"pipeline/formats/text/line_scanner.h LineScanner", {14, 16}},
        {"pipeline/simd/surfaces.h Surfaces", {12, 20}},
        {"pipeline/steps/steps.h Steps", {42, 5}},
    };
    return table;
}

std::string withoutComments(const SourceFile& file) {
    static const std::regex literal(R"rx("(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])')rx");
    std::string text;
    for (const std::string& line : file.lines) {
        const std::string plain = std::regex_replace(line, literal, "0");
        if (!plain.starts_with('#')) text += plain.substr(0, plain.find("//")) + ' ';
    }
    return text;
}

// Where the bracket at `open` closes.
std::size_t closing(const std::string& text, std::size_t open) {
    const char close = text[open] == '{' ? '}' : text[open] == '(' ? ')' : '>';
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        if (text[i] == text[open]) ++depth;
        if (text[i] == close && --depth == 0) return i;
    }
    return text.size() - 1;
}

// A declaration without template arguments, in which a comma or a bracket may stand.
std::string withoutArguments(std::string declaration) {
    for (std::size_t open = declaration.find('<'); open != std::string::npos; open = declaration.find('<', open)) {
        const std::size_t close = closing(declaration, open);
        declaration.erase(open, close - open + 1);
    }
    return declaration;
}

void count(const std::string& declaration, ClassSize& size) {
    static const std::regex other(
        R"(^\s*(using|friend|typedef|static_assert|enum|class|struct|static constexpr|static inline|$))");
    static const std::regex made(R"(=\s*(default|delete)\s*$)");
    if (std::regex_search(declaration, other) || std::regex_search(declaration, made)) return;
    const bool isOperator = declaration.find("operator") != std::string::npos;
    const std::string plain = isOperator ? declaration : withoutArguments(declaration);
    const std::size_t bracket = plain.find('('), value = plain.find_first_of("={");
    if (bracket != std::string::npos && (isOperator || value == std::string::npos || bracket < value)) {
        ++size.functions;
        return;
    }
    if (plain.starts_with("static ")) return;
    int depth = 0;
    ++size.members;
    for (const char c : plain) {
        if (c == '(' || c == '{' || c == '[') ++depth;
        if (c == ')' || c == '}' || c == ']') --depth;
        if (c == ',' && depth == 0) ++size.members;  // another name
    }
}

// The body of a class, from behind its bracket. Classes within it are not counted with it.
ClassSize sizeOf(const std::string& body) {
    static const std::regex label(
        R"(^\s*((public|protected|private)(\s+slots)?\s*:|signals\s*:|Q_OBJECT\b|template\s*))");
    ClassSize size;
    std::string declaration;
    for (std::size_t i = 0; i < body.size(); ++i) {
        std::smatch found;
        if (std::regex_search(declaration, found, label)) declaration = found.suffix();
        if (body[i] == '<' && declaration.empty()) {  // of a template
            i = closing(body, i);
            continue;
        }
        if (body[i] == ';') {
            count(declaration, size);
            declaration.clear();
        } else if (body[i] == '{') {
            i = closing(body, i);
            // A body ends a function; a value goes on to the semicolon, and one of an argument to its bracket.
            const bool isArgument = std::ranges::count(declaration, '(') > std::ranges::count(declaration, ')');
            if (!isArgument && withoutArguments(declaration).find('(') != std::string::npos && body[i + 1] != ';') {
                count(declaration, size);
                declaration.clear();
            } else {
                declaration += "{}";
            }
        } else if (!declaration.empty() || !std::isspace(static_cast<unsigned char>(body[i]))) {
            declaration += body[i];
        }
    }
    return size;
}

// Every class that a header defines. A struct is plain data.
std::map<std::string, ClassSize> classSizes(const SourceFile& file) {
    static const std::regex definition(R"(\bclass\s+(\w+)(\s+final)?\s*(:[^:;{](?:[^;{]|::)*)?\{)");
    static const std::regex ofEnumerators(R"(\benum\s*$)");
    std::map<std::string, ClassSize> sizes;
    const std::string text = withoutComments(file);
    for (std::sregex_iterator found(text.begin(), text.end(), definition), end; found != end; ++found) {
        if (std::regex_search(std::string(found->prefix()), ofEnumerators)) continue;
        const auto open = std::size_t(found->position() + found->length() - 1);
        sizes[(*found)[1]] = sizeOf(text.substr(open + 1, closing(text, open) - open - 1));
    }
    return sizes;
}

bool isLarge(const ClassSize& size) { return size.functions > kMost.functions || size.members > kMost.members; }

TEST(ClassSize, CountsFunctionsAndMembersOfAHeader) {
    const SourceFile file{"app/jobs/job.h",
                          {"class Other;",
                           "enum class Kind : unsigned char { A, B };",
                           "class Job : public QObject {",
                           "    Q_OBJECT",
                           "public:",
                           "    explicit Job(QObject* parent = nullptr);  // function one",
                           "    ~Job() override = default;",
                           "    int a() const { return m_a; }",
                           "    void open(const QString& file, const QString& name = {}, int page = {});",
                           "    template <class T>",
                           "    void take(T run, std::map<int, T> all) {",
                           "        if (m_a) { run(); }",
                           "    }",
                           "    bool operator==(const Job&) const;",
                           "    struct Row { int x; void f(); };",
                           "    using Rows = std::vector<Row>;",
                           "    static constexpr int kMost = 3;",
                           "signals:",
                           "    void changed(const QString& text = \"a;b\");",
                           "private:",
                           "    std::function<void(int)> m_done;",
                           "    QLabel *m_first, *m_second = nullptr;",
                           "    std::map<int, std::pair<int, int>> m_map{{1, {2, 3}}};",
                           "    int m_a = f(1, 2);",
                           "};"}};
    const auto sizes = classSizes(file);
    ASSERT_EQ(sizes.size(), 1u);
    EXPECT_EQ(sizes.at("Job").functions, 6) << "Job, a, open, take, operator==, changed";
    EXPECT_EQ(sizes.at("Job").members, 5) << "done, first, second, map, a";
}

TEST(ClassSize, ClassesAreSmall) {
    std::map<std::string, ClassSize> large;
    for (const SourceFile& file : readSourceTree(SHADESCOPE_ROOT)) {
        if (!file.path.ends_with(".h") || file.path.starts_with("tests/")) continue;
        for (const auto& [name, size] : classSizes(file))
            if (isLarge(size)) large[file.path + " " + name] = size;
    }
    for (const auto& [name, size] : large) {
        const auto row = largerThanMost().find(name);
        const ClassSize most = row == largerThanMost().end() ? kMost : row->second;
        EXPECT_TRUE(size.functions <= std::max(most.functions, kMost.functions) &&
                    size.members <= std::max(most.members, kMost.members))
            << name << " has " << size.functions << " functions and " << size.members
            << " members; a class has at most " << most.functions << " and " << most.members;
    }
    for (const auto& [name, size] : largerThanMost()) {
        const auto now = large.find(name);
        EXPECT_TRUE(now != large.end()) << name << " is small now: take it out of the list";
        if (now == large.end()) continue;
        EXPECT_TRUE(now->second.functions >= size.functions && now->second.members >= size.members)
            << name << " has become smaller: the list has " << size.functions << " and " << size.members << ", it has "
            << now->second.functions << " and " << now->second.members;
    }
}

}  // namespace
}  // namespace architecture
