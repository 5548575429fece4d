livenAll(document, {
  series: "series",
  figureIn: what => "zoom in: " + what,
  figureOut: what => "zoom out: " + what,
  figureSvg: what => "download the figure " + what + " as SVG",
  figureCsv: what => "download the data of " + what + " as CSV",
  sortBy: text => "sort by " + text,
}, () => document.querySelector("style").textContent.split("\n:root")[0]);

// A served page asks now and then whether it is still true.
function live(version) {
  const ask = async () => {
    try {
      const [now, ...told] = (await (await fetch("/version")).text()).split("\n");
      // The last good page stays while a file is wrong.
      const trouble = document.getElementById("trouble");
      if (trouble) {
        trouble.hidden = !told.length;
        trouble.querySelector("code").textContent = told.join("\n");
      }
      if (now !== String(version)) {
        sessionStorage.setItem("scroll", scrollY);
        location.reload();
        return;
      }
    } catch { /* the server may be starting again */ }
    setTimeout(ask, 400);
  };
  const scroll = sessionStorage.getItem("scroll");
  if (scroll !== null) { sessionStorage.removeItem("scroll"); scrollTo({ top: Number(scroll), behavior: "instant" }); }
  setTimeout(ask, 400);
}
