#pragma once
#include <QWidget>
#include <optional>

#include "app/core/document.h"
#include "pipeline/inspect/pixel_report.h"

class QLabel;

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

signals:
    void pointedAt(const QString& refers);
    void bufferAsked(const pipeline::BufferName& name);

private:
    Document& m_document;
    MathView* m_math;
    QWidget* m_switcher;
    QLabel* m_model;
    Segmented* m_channels;
    std::optional<glm::ivec2> m_pixel;  // of what is shown
    int m_channel = -1;
    std::vector<pipeline::EquationLine> m_plain;  // what is shown, without notes of ours
    QString m_was;                                // the result before the newest change; may be empty
};

}  // namespace app
