#include "lessons/pages/site.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <numeric>
#include <set>

#include "lessons/library.h"
#include "lessons/pages/handout.h"
#include "lessons/pages/manual_page.h"
#include "lessons/pages/page_parts.h"
#include "pipeline/core/version.h"
#include "pipeline/export/html/html_text.h"
#include "pipeline/formats/built_in_scenes.h"
#include "pipeline/formats/scene_folder.h"
#include "pipeline/formats/scene_reader.h"

namespace lessons {

namespace {

using pipeline::Error;
using pipeline::escapedHtml;
using pipeline::Result;
namespace fs = std::filesystem;

constexpr const char *kCoreFile = "shadescope-core.js", *kIndexFile = "index.html";

// A page without scripts around `body`.
std::string paperPage(const std::string& style, std::string_view title, const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
        "http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; style-src '{}'; img-src 'self' file: data:; base-uri 'none'; form-action "
        "'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<title>{}</title>\n<style>{}</style>\n"
        "</head>\n<body>\n{}</body>\n</html>\n",
        policyHash(style), escapedHtml(title), style, body);
}

std::string link(std::string_view address, std::string_view words) {
    return fmt::format("<a href=\"{}\">{}</a>", escapedHtml(address), escapedHtml(words));
}

// The file of the manual's page README.md or NAME.md.
std::string manualFile(std::string_view stem) {
    return stem == "README" ? "manual.html" : fmt::format("manual-{}.html", stem);
}

class SiteWriter {
public:
    SiteWriter(LiveParts parts, const DrawView& draw, const pipeline::Stop& stop, const SiteProgress& progress)
        : m_parts(std::move(parts)), m_draw(draw), m_stop(stop), m_progress(progress) {}

    Result<Site> write() {
        for (const std::string_view name : {"tokens.css", "site.css"}) {
            const auto style = readPageFile(name);
            if (!style) return style.errors();
            m_style += *style;
        }
        m_manual = pipeline::resourceFolder() / "manual";
        const Library library = allLessons();
        if (!library.errors.empty()) return library.errors;
        const std::vector<pipeline::BuiltInScene> scenes = pipeline::builtInScenes();
        const std::vector<fs::path> talks = filesOf(".cues"), manual = filesOf(".md");
        m_all = library.lessons.size() + scenes.size() + talks.size() + manual.size();

        auto ofWhole = liveParts(LiveKind::Whole);
        if (!ofWhole) return ofWhole.errors();
        LiveParts whole = std::move(ofWhole).value();
        m_parts.core = whole.core;  // one for all pages: it has the calls of a lesson's too
        add(kCoreFile, "globalThis.sharedCore = '" + pipeline::base85(m_parts.core) + "';\n");
        m_parts.sharedCore = whole.sharedCore = kCoreFile, m_parts.index = kIndexFile;
        std::set<std::string> pages;
        for (const fs::path& file : manual) pages.insert(file.stem().string());
        std::vector<Entry> noEntries;
        takeTurns(talks, m_talks, [&](const fs::path& file, Entry& entry) { addTalk(file, entry); });
        takeTurns(library.lessons, m_lessons, [&](const Lesson& lesson, Entry& entry) { addLesson(lesson, entry); });
        takeTurns(scenes, m_scenes, [&](const pipeline::BuiltInScene& scene, Entry& entry) { addScene(scene, entry); });
        takeTurns(manual, noEntries, [&](const fs::path& file, Entry&) { addManual(file, pages); });
        std::ranges::stable_sort(m_turns, {}, &Turn::place);
        for (const Turn& turn : m_turns) turn.make();
        if (m_stop.stop_requested()) return Error{{}, "stopped", {}};
        if (!m_errors.empty()) return m_errors;
        std::erase_if(m_talks, [](const Entry& talk) { return talk.file.empty(); });
        auto index = makeWholePage(whole, m_stop, {}, {lists(), paperIndex()});
        if (!index) return index.errors();
        add(kIndexFile, std::move(index).value());
        return std::move(m_site);
    }

private:
    // A page as the index has it. An empty file: it was left out.
    struct Entry {
        std::string file, title, says, facts{}, paper{};
    };
    // Each kind of page is spread evenly over the time, and so are the first and the last pages of a kind: a talk takes
    // much longer than a page of the manual, the last lesson thirty times as long as the first. Only a mixture tells from
    // the time so far how much is left.
    struct Turn {
        double place;  // 0 to 1
        std::function<void()> make;
    };
    // 1/2, 1/4, 3/4, 1/8, …: sorted by it, things from everywhere in their list come at any time (van der Corput).
    static double spread(std::size_t n) {
        double place = 0, digit = 0.5;
        for (++n; n > 0; n /= 2, digit /= 2) place += double(n % 2) * digit;
        return place;
    }
    // entries: of the index, in the order of the things.
    template <class Things, class Make>
    void takeTurns(const Things& things, std::vector<Entry>& entries, Make make) {
        entries.resize(things.size());
        std::vector<std::size_t> order(things.size());
        std::iota(order.begin(), order.end(), 0);
        std::ranges::sort(order, {}, spread);
        for (std::size_t i = 0; i < order.size(); ++i)
            m_turns.push_back({(double(i) + 0.5) / double(order.size()),
                               [make, &thing = things[order[i]], &entry = entries[order[i]]] { make(thing, entry); }});
    }
    void add(std::string name, std::string bytes) { m_site.files.emplace_back(std::move(name), std::move(bytes)); }
    // False: stopped.
    bool begin(const std::string& what) {
        if (m_progress) m_progress(m_done++, m_all, what);
        return !m_stop.stop_requested();
    }
    std::vector<fs::path> filesOf(const char* ending) const {
        std::vector<fs::path> files;
        std::error_code ignored;
        for (const auto& entry : fs::directory_iterator(m_manual, ignored))
            if (entry.path().extension() == ending) files.push_back(entry.path());
        std::ranges::sort(files);
        return files;
    }
    template <class T>
    bool isMade(const Result<T>& made) {
        if (made) return true;
        m_errors.insert(m_errors.end(), made.errors().begin(), made.errors().end());
        return false;
    }
    void leaveOut(const std::string& name, const std::string& why) { m_site.leftOut.push_back(name + ": " + why); }

    void addTalk(const fs::path& file, Entry& entry) {
        if (!begin("talk " + file.stem().string())) return;
        if (!m_draw) return leaveOut(file.filename().string(), "this build draws no views");
        const auto parts = talkParts();
        const auto list = readCueFile(file, m_stop);
        if (!isMade(parts) || !isMade(list)) return;
        auto page = makeTalkPage(*list, m_manual, *parts, m_draw, m_stop);
        if (!isMade(page)) return;
        for (const std::string& line : page->leftOut) leaveOut(file.filename().string(), line);
        const std::string name = "talk-" + file.stem().string() + ".html";
        entry = {name, list->title.empty() ? file.stem().string() : list->title,
                 fmt::format("{} cues, {} minutes.", list->cues.size(), list->minutes)};
        add(name, std::move(page->html));
    }

    void addLesson(const Lesson& lesson, Entry& entry) {
        if (!begin("lesson " + lesson.name)) return;
        auto page = makeLivePage(lesson, m_parts, m_stop);
        auto handout = makeHandout(lesson, m_stop);
        if (!isMade(page) || !isMade(handout)) return;
        for (const Error& error : page->leftOut) leaveOut(lesson.name, format(error));
        const std::string live = livePageFile(lesson.name), paper = "lesson-" + lesson.name + "-paper.html";
        entry = {live, lesson.title, lesson.summary, fmt::format("{}, {} pages", lesson.lecture, lesson.pages.size()),
                 paper};
        add(live, std::move(page->html));
        add(paper, std::move(handout->pages));
    }

    void addScene(const pipeline::BuiltInScene& scene, Entry& entry) {
        if (!begin("scene " + scene.name)) return;
        const auto read = pipeline::readScene(scene.file);
        if (!isMade(read)) return;
        auto page = makeLivePage(*read, scene.title, scene.look, {}, m_parts, m_stop);
        if (!isMade(page)) return;
        const std::string name = "scene-" + scene.name + ".html";
        entry = {name, scene.title, scene.look};
        add(name, std::move(page->html));
    }

    void addManual(const fs::path& file, const std::set<std::string>& pages) {
        if (!begin("manual " + file.stem().string())) return;
        const auto text = pipeline::readFile(file);
        if (!isMade(text)) return;
        const auto address = [&](std::string_view to) { return manualAddress(to, pages); };
        const std::string body = manualHtml(*text, address);
        std::string title(std::string_view(*text).substr(0, text->find('\n')));
        title.erase(0, title.find_first_not_of("# "));
        add(manualFile(file.stem().string()),
            paperPage(m_style, title,
                      "<nav>" + link(kIndexFile, "Shadescope") + " › " + link("manual.html", "Manual") +
                          "</nav>\n<main>" + body + "</main>\n"));
    }

    // Of a link or picture in the manual; empty where it leads out of the site.
    std::string manualAddress(std::string_view to, const std::set<std::string>& pages) {
        if (to.starts_with("#") || to.starts_with("https://")) return std::string(to);
        const std::size_t hash = std::min(to.find('#'), to.size());
        const fs::path path(to.substr(0, hash));
        if (path.extension() == ".md" && !path.has_parent_path() && pages.contains(path.stem().string()))
            return manualFile(path.stem().string()) + std::string(to.substr(hash));
        if (path.extension() != ".png" || path.parent_path() != "../pictures") return {};
        const std::string name = "picture-" + path.filename().string();
        if (m_pictures.insert(name).second) {
            auto bytes = pipeline::readFile(m_manual / path);
            if (!isMade(bytes)) return {};
            add(name, std::move(bytes).value());
        }
        return name;
    }

    // What the page that is the index does not show itself.
    pipeline::Json lists() const {
        using pipeline::Json;
        Json lectures = Json::array(), paper = Json::array();
        for (const Entry& talk : m_talks)
            lectures.push_back({{"file", talk.file}, {"title", talk.title}, {"note", talk.says}});
        for (const Entry& lesson : m_lessons)
            paper.push_back({{"file", lesson.paper}, {"title", lesson.title}, {"note", lesson.facts}});
        const Json manual{{"file", "manual.html"}, {"title", "The manual of the program"}, {"note", ""}};
        Json all = Json::array();
        if (!m_talks.empty()) all.push_back({{"heading", "Lectures"}, {"entries", lectures}});
        all.push_back({{"heading", "Lessons on paper"}, {"entries", paper}});
        all.push_back({{"heading", "Manual"}, {"entries", Json::array({manual})}});
        return all;
    }
    // All pages, for a browser without scripts.
    std::string paperIndex() const {
        const auto part = [](std::string_view heading, const std::vector<Entry>& entries) {
            std::string list;
            for (const Entry& entry : entries) {
                list += "<li>" + link(entry.file, entry.title);
                if (!entry.paper.empty())
                    list += fmt::format(" <span class=\"note\">{}, {}</span>", escapedHtml(entry.facts),
                                        link(entry.paper, "on paper"));
                list += "<p>" + escapedHtml(entry.says) + "</p></li>\n";
            }
            return list.empty() ? list : fmt::format("<section><h2>{}</h2><ul>\n{}</ul></section>\n", heading, list);
        };
        return part("Lectures", m_talks) + part("Lessons", m_lessons) + part("Scenes", m_scenes) +
               part("Manual", {{"manual.html", "The manual of the program", ""}}) +
               "<footer class=\"note\">Made by Shadescope " + escapedHtml(pipeline::programVersion()) + ".</footer>\n";
    }

    LiveParts m_parts;
    const DrawView& m_draw;
    pipeline::Stop m_stop;
    const SiteProgress& m_progress;
    std::vector<Turn> m_turns;
    std::size_t m_done = 0, m_all = 0;
    fs::path m_manual;
    std::string m_style;
    std::vector<Entry> m_talks, m_lessons, m_scenes;
    std::set<std::string> m_pictures;
    pipeline::Errors m_errors;
    Site m_site;
};

}  // namespace

Result<Site> makeSite(const LiveParts& parts, const DrawView& draw, const pipeline::Stop& stop,
                      const SiteProgress& progress) {
    return SiteWriter(parts, draw, stop, progress).write();
}

}  // namespace lessons
