#pragma once
#include <QWidget>

class QLabel;
class QLayout;
class QProgressBar;
class QPushButton;

namespace app {

class RendererFinding;
class StandingMark;

// How far a comparison is, and a button that stops it.
class RendererWork : public QWidget {
public:
    RendererWork(RendererFinding& finding, QWidget* parent);

    void showState();

private:
    RendererFinding& m_finding;
    QLabel* m_words;
    QProgressBar* m_bar;
    QPushButton* m_cancel;
};

// The top of My renderer: which files, the first wrong stage in words, and what cannot be compared.
class RendererHead : public QWidget {
    Q_OBJECT
public:
    RendererHead(RendererFinding& finding, QWidget* parent);

signals:
    void folderAsked();

private:
    QLayout* makeSource();
    void showState();
    void showReport();

    RendererFinding& m_finding;
    QLabel *m_source, *m_heading, *m_evidence, *m_errors;
    StandingMark* m_mark;
    RendererWork* m_work;
};

// A text of files, which is shown as it is.
QLabel* rendererText(const char* name, double size, int weight, QWidget* parent);
QPushButton* rendererButton(const QString& text, const char* name, QWidget* parent);

}  // namespace app
