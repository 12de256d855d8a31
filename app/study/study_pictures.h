#pragma once
#include <QWidget>
#include <array>

#include "app/study/study_images.h"

class QLabel;
class QPushButton;

namespace app {

// A picture as large as fits, its pixels sharp, with a line beneath it.
class PictureFrame : public QWidget {
    Q_OBJECT
public:
    explicit PictureFrame(QWidget* parent = nullptr);
    void show(QImage picture, const QString& caption, const QString& instead);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QRect pictureRect() const;

    QImage m_picture;
    QString m_caption, m_instead;
};

// Image, reference and signed error of the chosen setting side by side, and the button that takes
// its settings over.
class StudyPicturesView : public QWidget {
    Q_OBJECT
public:
    explicit StudyPicturesView(QWidget* parent = nullptr);

    // title: "flat, tessellation 16"; numbers: "0.79 ms, RMSE 1.1e-2". Empty where nothing is chosen.
    void setPoint(const QString& title, const QString& numbers, const QString& whyNotUsable);
    void setPictures(const SettingPictures& pictures);
    void setWaiting();

signals:
    void useAsked();

private:
    QLabel *m_title, *m_numbers;
    QPushButton* m_use;
    std::array<PictureFrame*, 3> m_frames;
};

}  // namespace app
