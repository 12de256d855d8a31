#pragma once
#include <QWidget>
#include <optional>

#include "app/document/document.h"
#include "pipeline/inspect/pixel_report.h"

class QLabel;
class QToolButton;

namespace app {

class MathView;
class Segmented;

// The illumination equation of a pixel for one channel, and what it was before the newest change.
class EquationSection : public QWidget {
    Q_OBJECT
public:
    explicit EquationSection(Document& document, QWidget* parent = nullptr);

    void show(const pipeline::Frame& frame, const pipeline::PixelReport& report);
    void forget();  // what was shown before: another scene
    QString sentence() const;
    QWidget* switcher() { return m_switcher; }  // r g b, with the model's name: for the section's title
    MathView* math() { return m_math; }
    // Keeps the current result on show, whatever changes, until it is dropped.
    bool canKeep() const { return m_was || m_kept; }
    bool keeps() const { return m_kept.has_value(); }
    void setKept(bool kept);

signals:
    void bufferAsked(const pipeline::BufferName& name);
    void settingAsked(const QString& key);
    void keptChanged();  // keeps(), or canKeep()

private:
    void layLines(bool showChange);

    // What an equation's result comes from; as numbers, so that it can be written anew in another format.
    struct Result {
        std::shared_ptr<const pipeline::Scene> scene;
        pipeline::PixelReport report;
        int channel = 0;
        std::vector<pipeline::EquationLine> lines() const;  // in the format in force; none where nothing was drawn
        QString text() const;                               // "45.000 + 69.714 + 0.025 = 114.739"
    };
    struct Past {
        Result result;
        QString with;  // ", with n = 4"
        QString text() const { return result.text() + with; }
    };

    Document& m_document;
    MathView* m_math;
    QWidget* m_switcher;
    QLabel* m_model;
    QToolButton* m_keep;
    Segmented* m_channels;
    Result m_now, m_before;  // before the newest step of undo, a whole drag being one
    std::optional<Past> m_was, m_kept;
};

}  // namespace app
