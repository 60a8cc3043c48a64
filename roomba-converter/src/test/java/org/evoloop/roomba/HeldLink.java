package org.evoloop.roomba;

import java.util.concurrent.CountDownLatch;
import java.util.function.IntFunction;
import org.evoloop.link.ForwardingLink;
import org.evoloop.link.Link;

/**
 * A link on which a test can hold a command, before it is sent, or after the robot has received it but before the send
 * returns.
 */
final class HeldLink extends ForwardingLink {
    private final Hold hold;

    private HeldLink(Link link, Hold hold) {
        super(link);
        this.hold = hold;
    }

    /** What is held, shared by all links of one cable. */
    static final class Hold {
        private volatile int before = -1;
        private volatile int after = -1;
        private volatile CountDownLatch held = new CountDownLatch(1);
        private volatile CountDownLatch free = new CountDownLatch(0);

        /** A cable that can be held. */
        IntFunction<Link> on(IntFunction<Link> cable) {
            return baud -> new HeldLink(cable.apply(baud), this);
        }

        /** The next command with this opcode is not sent until it is {@link #release released}. */
        void before(int opcode) {
            arm();
            before = opcode;
        }

        /** The next command with this opcode is sent, but its send does not return. */
        void after(int opcode) {
            arm();
            after = opcode;
        }

        private void arm() {
            held = new CountDownLatch(1);
            free = new CountDownLatch(1);
        }

        /** Waits until the command is held. */
        void await() throws InterruptedException {
            held.await();
        }

        void release() {
            before = -1;
            after = -1;
            free.countDown();
        }

        /** Waits however often the thread is interrupted. */
        private void stay() {
            held.countDown();
            boolean interrupted = false;
            while (free.getCount() > 0) {
                try {
                    free.await();
                } catch (InterruptedException later) {
                    interrupted = true;
                }
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    @Override
    public void send(byte[] bytes) {
        int opcode = bytes.length == 1 ? bytes[0] & 0xFF : -1;
        if (opcode >= 0 && opcode == hold.before) {
            hold.stay();
        }
        super.send(bytes);
        if (opcode >= 0 && opcode == hold.after) {
            hold.stay();
        }
    }
}
