package org.evoloop.roomba.link;

import org.jspecify.annotations.Nullable;

/** Another link with something about it that a test wants to be different. */
public abstract class ForwardingLink implements Link {
    private final Link link;

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
