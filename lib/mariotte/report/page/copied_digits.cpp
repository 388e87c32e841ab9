#include "mariotte/report/page/copied_digits.hpp"

namespace mariotte::report {

// A copy of what is selected, with other words in its cells, is laid out beside the page, so that the browser
// itself puts tabs between cells and breaks between lines.
const char* const copied_digits = R"(<script>
(function () {
  function element(range) {
    const common = range.commonAncestorContainer;
    return common.nodeType === Node.ELEMENT_NODE ? common : common.parentNode;
  }
  function laid_out(range) {
    const at = element(range), part = at.closest('tr, tbody, table') === at ? at.cloneNode(false) : null;
    const place = document.createElement(part ? 'table' : 'div');
    (part || place).append(range.cloneContents());
    if (part) place.append(...(part.tagName === 'TABLE' ? part.childNodes : [part]));
    place.querySelectorAll('td[title]').forEach(cell => cell.textContent = cell.title);
    place.style.cssText = 'position: absolute; left: -9999px';
    document.body.append(place);
    const text = place.innerText;
    place.remove();
    return text;
  }
  document.addEventListener('copy', event => {
    const selection = getSelection();
    if (selection.isCollapsed || selection.rangeCount !== 1) return;
    const range = selection.getRangeAt(0), cell = element(range).closest('td[title]');
    if (cell && selection.toString().trim() !== cell.textContent) return;  // some of its digits
    event.clipboardData.setData('text/plain', cell ? cell.title : laid_out(range));
    event.preventDefault();
  });
})();
</script>
)";

}  // namespace mariotte::report
