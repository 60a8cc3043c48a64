package org.evoloop.line;

import java.io.IOException;
import org.evoloop.payload.RemoteFunction;

/**
 * A program that runs functions, as lines that are JSON objects; other lines are not for functions.
 *
 * <p>Threading: as {@link RemoteFunction.Channel}.
 */
final class LineFunctions implements RemoteFunction.Channel {
    private final LineConnection connection;
    private final Reconnector wire;

    LineFunctions(LineConnection connection, Reconnector wire) {
        this.connection = connection;
        this.wire = wire;
    }

    @Override
    public boolean isUp() {
        return wire.isUp();
    }

    @Override
    public String tell(String verb, String json) {
        try {
            wire.write(json);
            return "";
        } catch (IOException failure) {
            return String.valueOf(failure.getMessage());
        }
    }

    @Override
    public void listen(RemoteFunction.Listener listener) {
        connection.listen(line -> {
            if (line.startsWith("{")) {
                listener.heard("", line);
            }
        });
        wire.add(new WireUser() {
            @Override
            public void lost(String why) {
                listener.lost(why);
            }
        });
    }

    @Override
    public String toString() {
        return wire.place();
    }
}
