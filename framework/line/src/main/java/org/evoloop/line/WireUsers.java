package org.evoloop.line;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * All that are told of a wire, in the order in which they were added. One that cannot deal with a line keeps it from
 * nobody else.
 *
 * <p>Threading: {@link #add} may be called from any thread.
 */
final class WireUsers implements WireUser {
    private static final Logger LOG = LoggerFactory.getLogger(LineConnection.class);

    private final String place;
    private final List<WireUser> all = new CopyOnWriteArrayList<>();
    private final Set<String> complaints = new HashSet<>();

    /** @param place where the wire leads, for messages */
    WireUsers(String place) {
        this.place = place;
    }

    void add(WireUser user) {
        all.add(user);
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
                LOG.warn("'{}' of {} cannot be dealt with", line, place, failure);
            }
        }
    }

    @Override
    public void lost(String why) {
        all.forEach(user -> user.lost(why));
    }

    /** What has come is no line; each kind of it is logged once. */
    void complain(String about) {
        if (complaints.add(about)) {
            LOG.warn("{}: {}", place, about);
        }
    }
}
