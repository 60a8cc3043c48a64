package org.evoloop.line;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * All users of a wire, in their order. If one fails on a line, the others still receive it.
 *
 * <p>Threading: {@link #add} and {@link #addFirst} may be called from any thread.
 */
final class WireUsers implements WireUser {
    private static final Logger LOG = LoggerFactory.getLogger(LineConnection.class);

    private final String place;
    private final List<WireUser> all = new CopyOnWriteArrayList<>();
    private final Set<String> complaints = new HashSet<>();

    /** @param place the wire's destination, for messages */
    WireUsers(String place) {
        this.place = place;
    }

    void add(WireUser user) {
        all.add(user);
    }

    /** Adds a user that is called before those that are there. */
    void addFirst(WireUser user) {
        all.add(0, user);
    }

    @Override
    public void connected() throws IOException {
        for (WireUser user : all) {
            user.connected();
        }
    }

    @Override
    public void heard(String line) {
        for (WireUser user : all) {
            try {
                user.heard(line);
            } catch (RuntimeException failure) {
                LOG.warn("'{}' of {} could not be handled", line, place, failure);
            }
        }
    }

    @Override
    public void lost(String why) {
        all.forEach(user -> user.lost(why));
    }

    /** Logs that a received line was skipped, once for each reason. */
    void complain(String about) {
        if (complaints.add(about)) {
            LOG.warn("{}: {}", place, about);
        }
    }
}
