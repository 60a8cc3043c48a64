package org.evoloop.link;

import org.jspecify.annotations.Nullable;

/**
 * Forwards to another link; a subclass overrides what differs.
 *
 * <p>Threading: as {@link Link}.
 *
 * @since 0.1
 */
public abstract class ForwardingLink implements Link {
    private final Link link;

    /** @param link the link to forward to */
    protected ForwardingLink(Link link) {
        this.link = link;
    }

    @Override
    public int receive(byte[] buffer) {
        return link.receive(buffer);
    }

    @Override
    public @Nullable LinkException loss() {
        return link.loss();
    }

    @Override
    public void send(byte[] bytes) {
        link.send(bytes);
    }

    @Override
    public WakeLine wakeLine() {
        return link.wakeLine();
    }

    @Override
    public String description() {
        return link.description();
    }

    @Override
    public void close() {
        link.close();
    }
}
