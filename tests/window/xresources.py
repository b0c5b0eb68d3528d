"""Resources of a display, such as a desktop keeps its monitor's scale in, with nothing but libX11."""

import xdnd

RESOURCE_MANAGER, STRING, REPLACE = 23, 31, 0


class Resources:
    """Set until close(): a display without any client forgets them."""

    def __init__(self, display_name, **values):
        text = "".join(f"{name.replace('_', '.')}:\t{value}\n" for name, value in values.items()).encode()
        self.lib = xdnd.load()
        self.display = self.lib.XOpenDisplay(display_name.encode())
        assert self.display, f"cannot open {display_name}"
        root = self.lib.XDefaultRootWindow(self.display)
        self.lib.XChangeProperty(self.display, root, RESOURCE_MANAGER, STRING, 8, REPLACE, text, len(text))
        self.lib.XFlush(self.display)

    def close(self):
        self.lib.XCloseDisplay(self.display)
