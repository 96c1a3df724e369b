// Pictures of the page over a reference: the pointer, the slider or the arrow keys wipe; "flicker" shows them in turn.
document.documentElement.classList.add("live");
for (const comparison of document.querySelectorAll(".comparison")) {
  const part = name => comparison.querySelector(name);
  const stage = part(".stage"), other = part(".other"), edge = part(".edge"), slider = part("input");
  const buttons = comparison.querySelectorAll("[data-picture]");
  let at = 0.5, timer = 0;
  const show = () => {
    other.style.clipPath = `inset(0 ${100 - 100 * at}% 0 0)`;
    edge.style.left = 100 * at + "%";
    slider.value = 100 * at;
  };
  const choose = button => {
    for (const one of buttons) one.setAttribute("aria-pressed", one === button);
    other.src = document.getElementById(button.dataset.picture).src;
    other.alt = part(".tag.left").textContent = button.textContent;
  };
  const flicker = on => {
    clearInterval(timer);
    timer = on ? setInterval(() => { at = at === 1 ? 0 : 1; show(); }, 500) : 0;
    edge.hidden = on;
    part(".flicker").setAttribute("aria-pressed", on);
    at = on ? 1 : 0.5;
    show();
  };
  part(".reference").src = document.getElementById(comparison.dataset.reference).src;
  for (const button of buttons) button.onclick = () => choose(button);
  part(".flicker").onclick = () => flicker(!timer);
  slider.oninput = () => { if (timer) flicker(false); at = slider.value / 100; show(); };
  stage.onpointermove = event => {
    if (timer) return;
    const box = stage.getBoundingClientRect();
    at = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    show();
  };
  choose(part("[data-chosen]"));
  show();
}
