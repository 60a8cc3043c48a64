package org.evoloop.homeassistant;

import java.io.IOException;
import java.net.http.HttpClient;
import java.security.GeneralSecurityException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Values;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.evoloop.payload.report.Turns;
import org.evoloop.time.Attempts;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A connection to Home Assistant's WebSocket API that reconnects whenever it is lost, with pauses of 250 ms to 30 s. After
 * each connect it waits until Home Assistant has started, checks that there are the entities and services, and reads the
 * entities' states again. A fault is logged once, until it changes or ends. A token that was refused is not tried again:
 * Home Assistant counts that as an attack.
 *
 * <pre>{@code
 * HomeConnection home = new HomeConnection(HomeAddress.parse("http://homeassistant.local:8123"),
 *         () -> Secret.read(Path.of("token")));
 * }</pre>
 *
 * <p>Lifecycle: configure it by a {@link HomeDevice}, then {@link #open}, which does not wait; {@link #close}.
 *
 * <p>Threading: all methods may be called from any thread; only {@link #close} waits.
 *
 * @since 0.1
 */
public final class HomeConnection implements DeviceLink, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(HomeConnection.class);
    /** The client may miss that a connection ends right after a message; then this tells. */
    private static final Duration SILENCE = Duration.ofSeconds(3);

    private static final Duration STARTING = Duration.ofSeconds(1);
    private static final Duration PATIENCE = Duration.ofSeconds(10);
    private static final Duration END_LIMIT = Duration.ofSeconds(3);

    private final HomeAddress address;
    private final Turns turns = new Turns();
    private final Supplier<String> token;
    private final HttpClient client;
    private final HomeEntities entities = new HomeEntities();
    private final Set<ServiceCall> calls = new LinkedHashSet<>();
    private final Set<String> own = new LinkedHashSet<>();
    private final Expected expected = new Expected();
    private final Map<String, Subscription> subscriptions = new LinkedHashMap<>();
    private final List<Consumer<String>> whenLost = new CopyOnWriteArrayList<>();
    private final Attempts attempts = new Attempts();
    private final CountDownLatch closed = new CountDownLatch(1);
    private @Nullable Thread thread;
    private @Nullable String refusedToken;
    private volatile @Nullable HomeSession session;
    private volatile boolean closing;
    private volatile @Nullable Instant downSince = Instant.now();
    private volatile String trouble;

    /** Events that are subscribed to after each connect. */
    private record Subscription(String request, String part, List<Consumer<String>> consumers) {}

    /**
     * A connection.
     *
     * @param token gives the long-lived access token, before each connect; its {@link IllegalArgumentException} says why
     *     there is none
     */
    public HomeConnection(HomeAddress address, Supplier<String> token) {
        this.address = address;
        this.token = token;
        this.trouble = address + " has not been reached yet";
        HttpClient.Builder builder = HttpClient.newBuilder();
        TrustManagerFactory trust = address.trust();
        if (trust != null) {
            try {
                SSLContext context = SSLContext.getInstance("TLS");
                context.init(null, trust.getTrustManagers(), null);
                builder.sslContext(context);
            } catch (GeneralSecurityException impossible) {
                throw new IllegalStateException(impossible);
            }
        }
        this.client = builder.build();
    }

    /**
     * Declares that a converter is shown in Home Assistant under this name at its broker: none of its entities may be
     * its device or its controller. Before {@link #open}.
     */
    public HomeConnection shownAs(String id) {
        own.add(id.replaceAll("[^A-Za-z0-9_-]", "_"));
        return this;
    }

    /** In which reports are heard; what a timer says of them is said there, too. */
    Turns turns() {
        return turns;
    }

    /** Sets who hears of an entity; before {@link #open}. */
    void listen(String entity, HomeEntities.Listener listener) {
        entities.add(entity, listener);
    }

    /**
     * Declares that this value will be heard of, so that it is checked after each connect that its entity has the
     * attribute, and may be these texts, as far as Home Assistant tells; before {@link #open}.
     */
    public HomeConnection expect(EntityValue value, String... texts) {
        expected.add(value, Set.of(texts));
        return this;
    }

    /**
     * Says where something was written that turns out to be wrong, for messages; before {@link #open}.
     *
     * @param what the text of an entity's id, of an {@link EntityValue}, of a {@link ServiceCall}, or of {@link HomeEvents}
     * @param place such as {@code lamp.yaml:6}
     */
    public HomeConnection placed(String what, String place) {
        entities.place(what, place);
        return this;
    }

    /** Sets who hears of the events of a subscription; before {@link #open}. */
    void listen(JsonObject request, String part, Consumer<String> consumer) {
        subscriptions
                .computeIfAbsent(request.toString(), text -> new Subscription(text, part, new CopyOnWriteArrayList<>()))
                .consumers()
                .add(consumer);
    }

    /** Declares that a service will be called, so that it is checked after each connect; before {@link #open}. */
    public void require(ServiceCall call) {
        calls.add(call);
    }

    /** Sets an action for each time that the connection is lost, which receives the reason; before {@link #open}. */
    void onLost(Consumer<String> action) {
        whenLost.add(action);
    }

    HomeEntities entities() {
        return entities;
    }

    /** Starts connecting; does nothing if it was opened before. */
    public synchronized void open() {
        if (thread == null) {
            thread = new Thread(this::run, "home-assistant");
            thread.setDaemon(true);
            thread.start();
        }
    }

    /**
     * Calls a service. The answer comes when Home Assistant has carried it out; it is a {@link HomeException} if it has
     * not.
     */
    CompletableFuture<JsonRecord> call(ServiceCall call, Values values) {
        return request(call.request(values));
    }

    /**
     * Calls a service, and waits until Home Assistant has carried it out, at most 10 s.
     *
     * @throws UnknownEffectException if it is not known whether it has
     * @throws IOException if it has not
     */
    public void carryOut(ServiceCall call, Values values) throws IOException, InterruptedException {
        try {
            call(call, values).get(PATIENCE.toMillis(), TimeUnit.MILLISECONDS);
        } catch (ExecutionException failure) {
            String why = call.failed(failure.getCause());
            throw HomeException.isRefusal(failure.getCause())
                    ? new IOException(why, failure)
                    : new UnknownEffectException(why, failure);
        } catch (TimeoutException late) {
            throw new UnknownEffectException(call + " was not answered within " + PATIENCE.toSeconds() + " s", late);
        }
    }

    CompletableFuture<JsonRecord> request(JsonObject request) {
        HomeSession now = session;
        return now == null
                ? CompletableFuture.failedFuture(new HomeException("not_allowed", describe()))
                : now.request(request);
    }

    private void run() {
        try {
            while (!closing) {
                connectAndServe();
                if (!closing) {
                    closed.await(attempts.pause().toMillis(), TimeUnit.MILLISECONDS);
                }
            }
        } catch (InterruptedException end) {
            // It is being closed.
        }
    }

    private void connectAndServe() throws InterruptedException {
        try {
            String secret = token.get();
            if (secret.equals(refusedToken)) {
                return;
            }
            try (HomeSession made = HomeSession.connect(client, address, secret)) {
                begin(made);
                serve(made);
            } catch (HomeException failure) {
                if (HomeSession.isRefusedToken(failure)) {
                    refusedToken = secret;
                    note(address
                            + " refuses the token: it is wrong, or was revoked; create a long-lived access token on "
                            + "Home Assistant's page of your user, under Security, and write it into the token's file, or "
                            + "into the environment and start this program again");
                } else {
                    note(String.valueOf(failure.getMessage()));
                }
            }
        } catch (IllegalArgumentException none) {
            note("there is no token for " + address + ": " + none.getMessage());
        } finally {
            session = null;
            if (downSince == null) {
                downSince = Instant.now();
            }
            String why = describe();
            entities.lost(why);
            whenLost.forEach(action -> action.accept(why));
        }
    }

    private void begin(HomeSession made) throws HomeException, InterruptedException {
        awaitStarted(made);
        made.ask(subscribing("entity_registry_updated"), entities::registered);
        new HomeChecks(made, address).run(entities, calls, own, expected);
        for (Subscription each : subscriptions.values()) {
            subscribe(made, each);
        }
        List<String> ids = entities.ids().stream()
                .filter(id -> entities.wrongWith(List.of(HomeChecks.loop(id))) == null)
                .toList();
        if (!ids.isEmpty()) {
            CountDownLatch read = new CountDownLatch(1);
            made.ask(new JsonObject().put("type", "subscribe_entities").putTexts("entity_ids", ids), event -> {
                entities.hear(event);
                read.countDown();
            });
            if (!read.await(PATIENCE.toMillis(), TimeUnit.MILLISECONDS)) {
                throw new HomeException(address + " does not tell the states of its entities");
            }
        }
        session = made;
        downSince = null;
        trouble = "";
        if (attempts.succeeded(System.nanoTime())) {
            LOG.info("connected to {}", address);
        }
    }

    static JsonObject subscribing(String eventType) {
        return new JsonObject().put("type", "subscribe_events").put("event_type", eventType);
    }

    /** Before that, many entities are not there yet. */
    private void awaitStarted(HomeSession made) throws HomeException, InterruptedException {
        while (!made.ask("get_config")
                .inner("result")
                .map(config -> config.text("state", "RUNNING"))
                .orElse("RUNNING")
                .equals("RUNNING")) {
            trouble = address + " is starting";
            if (made.awaitEnd(STARTING)) {
                throw new HomeException(made.end());
            }
        }
    }

    private void subscribe(HomeSession made, Subscription what) throws HomeException, InterruptedException {
        try {
            made.ask(JsonRecord.of(what.request()).copy(), event -> {
                String text = event.inner(what.part()).orElse(event).copy().toString();
                turns.take(() -> what.consumers().forEach(each -> each.accept(text)));
            });
            entities.isRight(what.request());
        } catch (HomeException refused) {
            if (!refused.isRefusal()) {
                throw refused;
            }
            entities.note(
                    what.request(),
                    address + " does not take the subscription " + what.request() + ": " + refused.getMessage()
                            + (refused.hasCode("unauthorized")
                                    ? "; these events need the token of an administrator"
                                    : ""));
        }
    }

    private void serve(HomeSession made) throws HomeException, InterruptedException {
        while (!closing) {
            if (made.awaitEnd(SILENCE)) {
                throw new HomeException(made.end());
            }
            made.ask("ping");
        }
    }

    private void note(String why) {
        trouble = why;
        if (!closing && attempts.failed(why, System.nanoTime())) {
            LOG.warn("{}; trying to connect again", why);
        }
    }

    /** What is wrong with the first of these entities, or with what is asked of them; null if nothing is. */
    @Nullable
    String wrongWith(Collection<String> keys) {
        List<String> all = new ArrayList<>(keys);
        keys.forEach(key -> all.add(HomeChecks.loop(key)));
        return entities.wrongWith(all);
    }

    @Override
    public boolean isUp() {
        HomeSession now = session;
        return now != null && now.isUp();
    }

    @Override
    public Optional<Instant> downSince() {
        return Optional.ofNullable(downSince);
    }

    @Override
    public String describe() {
        String why = trouble;
        return isUp() || why.isEmpty() ? address.toString() : why;
    }

    /** Disconnects and ends. Idempotent. */
    @Override
    public void close() {
        closing = true;
        closed.countDown();
        Thread running;
        synchronized (this) {
            running = thread;
        }
        if (running != null) {
            running.interrupt();
            if (!Threads.join(running, END_LIMIT)) {
                LOG.warn("the connection to {} has not ended within {} s", address, END_LIMIT.toSeconds());
            }
        }
    }
}
