// A window with its picture, from one turn of its loop to the next.
#pragma once

#include "live/event_log.h"
#include "live/live_input.h"
#include "live/memory.h"
#include "live/reloader.h"
#include "live/screenshot.h"
#include "live/stage.h"
#include "live/ui.h"
#include "live/window.h"

#include <deque>
#include <memory>
#include <set>

namespace dioptre
{

class Session
{
public:
    // Opens the window and asks for the first picture. Throws noOpenGl, and inputMissing for an input that is
    // not there.
    explicit Session(const LiveOptions& options);
    ~Session(); // keeps what is to be remembered
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Waits for something to do, does it, and shows what is new. False once the window is closed.
    bool turn();

    // Draws the picture anew, as a hand that moves the camera would.
    void moveOn()
    {
        moved_ = true;
    }

    // For those who measure.
    const LiveModel& model() const
    {
        return model_;
    }
    const Stage& stage() const
    {
        return stage_;
    }
    Window& window()
    {
        return window_;
    }
    bool isBusy() const
    {
        return reloader_.isBusy();
    }
    long framesShown() const
    {
        return framesShown_;
    }
    long picturesShown() const // reloads whose first frame was shown
    {
        return picturesShown_;
    }

private:
    void open(const std::filesystem::path& path);
    void forgetWrittenCamera();
    void recallHand(); // where the camera was left
    bool showsInput() const;
    void keep() const;
    void openAgain(const LiveInput& input);
    void ask();
    void apply(ReloadOutcome outcome);
    void fail(const Error& error);
    void dropFaultyChanges(const Error& error);

    // session_input.cpp
    void handle(const InputEvent& event);
    void handleButton(const InputEvent& event);
    void handleMove(const InputEvent& event);
    void handleKey(const InputEvent& event);
    void fly(double elapsed_s);
    bool isOverDivider(const glm::dvec2& at_px) const;
    void setCamera(const Camera& camera);

    // session_actions.cpp
    void act(Action action);
    bool actOnTime(Action action);
    bool actOnPicture(Action action);
    bool actOnFiles(Action action);
    void change(const std::string& path, const std::string& value);
    double wantedNumber(const std::string& path, double shown) const;
    void raiseLights(double metres);
    void nextLightType();
    void nextOrder();
    void nextView();
    void changeBudget(int difference);
    void changeSamples(int samples);

    // session_methods.cpp
    bool actOnMethods(Action action);
    void choose(const MethodChoice& choice);
    void showChoice();
    void drawDividerTo(double x_px);
    nlohmann::ordered_json methodDetails() const;

    // session_output.cpp
    void screenshot();
    void hearOfScreenshot();
    void writeBack();
    void notice(const std::string& text);
    void refuse(const Error& error); // what was asked for; the picture is as good as before

    // session_paint.cpp
    double waitTime_s();
    bool isToDraw() const;
    void follow(); // the window's size, the time, the camera
    void paint();
    void sayDone() const;
    void grant(const UiWishes& wishes);

    LiveOptions options_;
    std::optional<Remembered> remembered_; // of the input, until its first picture is there
    LiveInput input_;
    LiveModel model_;
    EventLog log_;
    Window window_;
    Stage stage_;
    Reloader reloader_;
    Ui ui_;

    std::deque<float> frames_ms_;
    LiveClock::Clock::time_point lastFrame_ = LiveClock::Clock::now();
    LiveClock::Clock::time_point lastTurn_ = LiveClock::Clock::now();
    LiveClock::Clock::time_point noticedAt_;
    std::optional<ScreenshotJob> shot_;     // one that is being drawn
    LiveClock::Clock::time_point lookedAt_; // when the camera was last asked after by the loader
    LiveClock::Clock::time_point takenAt_;  // when the last reload reached the device
    bool lostMeasured_ = false;             // of what is shown
    long framesShown_ = 0;
    long picturesTaken_ = 0; // reloads that have reached the device
    long picturesShown_ = 0;
    int paints_ = 3;              // still to be made: the panel takes some frames to settle
    bool moved_ = false;          // the picture's moment, camera, size or samples
    bool looksElsewhere_ = false; // the camera, so that the plan is to be looked at again
    bool wasDone_ = false;
    bool rested_ = true;    // since the last frame: the next follows none
    bool flies_ = false;    // a key that moves the camera is held
    std::set<int> flyKeys_; // that are down and were pressed without Ctrl
    bool dividerHeld_ = false;
    int dragged_ = -1; // the button that is held over the picture
    glm::dvec2 pointer_px_{0.0};
};

} // namespace dioptre
