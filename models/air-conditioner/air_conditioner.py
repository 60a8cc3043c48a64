"""A simulated air conditioner that sends and receives lines: python3 air_conditioner.py [PORT].

Type the buttons of its remote control (power, mode, turbo, boost), or tooCold, which it does by itself.
"""

import socketserver
import sys
import threading

NEXT = {
    ("Off", "PWR"): "Cool",
    ("Cool", "PWR"): "Off",
    ("Dry", "PWR"): "Off",
    ("Turbo", "PWR"): "Off",
    ("Cool", "MODE"): "Dry",
    ("Dry", "MODE"): "Cool",
    ("Cool", "TRB"): "Turbo",
    ("Dry", "TRB"): "Turbo",
    ("Turbo", "TRB"): "Cool",
}
state = "Off"
clients = []


def go(to):
    global state
    state = to
    print("the air conditioner is", state, flush=True)


def tell(line):
    for client in clients:
        client.wfile.write(line.encode() + b"\n")


class AirConditioner(socketserver.StreamRequestHandler):
    def handle(self):
        clients.append(self)
        print("somebody is connected", flush=True)
        for line in self.rfile:
            word = line.decode().strip()
            if word == "STATE?":
                tell("is " + state)
            elif (state, word) in NEXT:
                go(NEXT[state, word])
                tell("OK")
            else:
                tell("ERR " + word)
        clients.remove(self)


class Server(socketserver.ThreadingTCPServer):
    allow_reuse_address = True
    daemon_threads = True


with Server(("127.0.0.1", int(sys.argv[1]) if len(sys.argv) > 1 else 4001), AirConditioner) as server:
    threading.Thread(target=server.serve_forever, daemon=True).start()
    go("Off")
    for line in sys.stdin:
        if line.strip() != "tooCold":
            tell("remote " + line.strip())
        elif state == "Turbo":
            go("Cool")
            tell("too cold")
    server.shutdown()
