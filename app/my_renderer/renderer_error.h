#pragma once
#include <QWidget>

#include "pipeline/compare/verdict.h"

class QLabel;
class QVBoxLayout;

namespace app {

// The known error that explains somebody else's files, or the two and what tells them apart, or that none does.
class RendererError : public QWidget {
    Q_OBJECT
public:
    explicit RendererError(QWidget* parent = nullptr);

    // Hidden where the report has no suspects.
    void show(const pipeline::foreign::Report& report);

signals:
    void lessonAsked(const QString& lesson, const QString& heading);
    void rowsStated(bool otherRows);  // which of two that differ in how the rows are read is meant

private:
    void clear();
    QLabel* add(const QString& text, double size, int weight, bool isMono = false);
    void addShare(const QString& name, double share);
    void addCandidate(const pipeline::foreign::Candidate& candidate, int number);
    void addExperiment(const pipeline::foreign::Suspects& suspects);

    QLabel *m_title, *m_beside;
    QWidget* m_box;
    QVBoxLayout* m_column;
};

}  // namespace app
