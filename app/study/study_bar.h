#pragma once
#include <QStringList>
#include <QWidget>
#include <optional>

class QLabel;

namespace app {

// The bottom line of a study: its answers, as many as fit, or the current measurement; and the load of the machine.
class StudyBar : public QWidget {
    Q_OBJECT
public:
    explicit StudyBar(QWidget* parent = nullptr);

    void setAnswers(const QStringList& sentences);
    void tell(const QString& doing);  // empty: the answers again
    void setLoad(std::optional<double> load);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fit();

    QStringList m_answers;
    QString m_doing;
    QLabel *m_words, *m_load;
};

}  // namespace app
