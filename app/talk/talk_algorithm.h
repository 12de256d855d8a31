#pragma once
#include <QWidget>

class QLabel;

namespace app {

class AlgorithmView;
class Document;
class StepTables;

// The algorithm of the step beside the views: its lines, and below them why some are left out.
class TalkAlgorithm : public QWidget {
    Q_OBJECT
public:
    TalkAlgorithm(const Document& document, QWidget* parent);

    // `wanted`: the talk has room for it. It stays hidden where there is no algorithm, or the user has not asked for it.
    void showStep(bool wanted);

private:
    const Document& m_document;
    AlgorithmView* m_lines;
    StepTables* m_tables;
    QLabel* m_leftOut;
};

}  // namespace app
