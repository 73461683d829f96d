#include "live/ui.h"

#include "live/overlays.h"
#include "live/panel.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace dioptre
{

Ui::Ui(const Window& window)
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // what is remembered is remembered for each input, elsewhere
    ImGui::StyleColorsDark();
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

Ui::~Ui()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

UiWishes Ui::draw(const LiveModel& model, const UiFacts& facts)
{
    UiWishes wishes;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    if (model.showPanel)
        drawPanel(model, facts, wishes);
    if (model.fault) {
        drawStaleMark();
        drawFault(*model.fault);
    }
    if (model.showHelp)
        drawHelp();
    if (!model.notice.empty())
        drawNotice(model.notice);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return wishes;
}

bool Ui::wantsPointer() const
{
    return ImGui::GetIO().WantCaptureMouse;
}

bool Ui::wantsKeys() const
{
    return ImGui::GetIO().WantTextInput;
}

} // namespace dioptre
