package org.evoloop.homeassistant;

import java.net.ConnectException;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.net.http.WebSocketHandshakeException;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.UnresolvedAddressException;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import javax.net.ssl.SSLException;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One connection to Home Assistant's WebSocket API, from login to end.
 *
 * <p>Threading: thread-safe. Consumers of events, and what follows an answer, run on a thread of the client, one at a time,
 * in the order in which Home Assistant has sent them.
 */
final class HomeSession implements WebSocket.Listener, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(HomeSession.class);
    private static final Duration LIMIT = Duration.ofSeconds(10);
    private static final String REFUSED_TOKEN = "auth_invalid";

    private final HomeAddress address;
    private final Map<Long, CompletableFuture<JsonRecord>> answers = new ConcurrentHashMap<>();
    private final Map<Long, Consumer<JsonRecord>> subscribers = new ConcurrentHashMap<>();
    private final CompletableFuture<JsonRecord> greeting = new CompletableFuture<>();
    private final CompletableFuture<JsonRecord> login = new CompletableFuture<>();
    private final CountDownLatch ended = new CountDownLatch(1);
    private final StringBuilder text = new StringBuilder();
    private CompletableFuture<WebSocket> sent = new CompletableFuture<>();
    private @Nullable WebSocket socket;
    private volatile String end = "";
    private long last;

    private HomeSession(HomeAddress address) {
        this.address = address;
    }

    /**
     * Connects and logs in.
     *
     * @throws HomeException if there is no answer, or the token is refused, see {@link #isRefusedToken}
     */
    static HomeSession connect(HttpClient client, HomeAddress address, String token)
            throws HomeException, InterruptedException {
        HomeSession made = new HomeSession(address);
        try {
            made.begin(client.newWebSocketBuilder()
                    .connectTimeout(LIMIT)
                    .buildAsync(address.webSocket(), made)
                    .get(LIMIT.toMillis(), TimeUnit.MILLISECONDS));
            made.logIn(token);
            return made;
        } catch (ExecutionException failure) {
            made.close();
            throw new HomeException(address + " cannot be reached: " + reason(failure));
        } catch (TimeoutException late) {
            made.close();
            throw new HomeException(address + " cannot be reached: it has not answered within " + LIMIT.toSeconds()
                    + " s; check the address, and whether it begins with http:// or https://");
        } catch (HomeException | InterruptedException failure) {
            made.close();
            throw failure;
        }
    }

    private synchronized void begin(WebSocket open) {
        socket = open;
        sent = CompletableFuture.completedFuture(open);
    }

    private void logIn(String token) throws HomeException, InterruptedException {
        await(greeting, "a greeting");
        write(new JsonObject().put("type", "auth").put("access_token", token));
        String answer = await(login, "the login").text("type");
        if (!answer.equals("auth_ok")) {
            throw new HomeException(REFUSED_TOKEN, address + " refuses the token");
        }
    }

    static boolean isRefusedToken(HomeException failure) {
        return failure.hasCode(REFUSED_TOKEN);
    }

    private static String reason(Throwable failure) {
        Throwable cause = failure;
        while (cause.getCause() != null && !(cause instanceof SSLException)) {
            cause = cause.getCause();
        }
        String message = String.valueOf(cause.getMessage());
        if (message.contains("SSL message")) {
            return "it does not speak TLS there; begin the URL with http://, or check the port";
        }
        if (cause instanceof SSLException) {
            return "its certificate is not accepted (" + cause.getMessage()
                    + "); give the URL ?ca=FILE or ?sha256=FINGERPRINT, and the name for which it was made";
        }
        if (cause instanceof WebSocketHandshakeException) {
            return "what answers there is no Home Assistant; check the port";
        }
        if (cause instanceof UnresolvedAddressException) {
            return "there is no computer of this name; check the name, or write its number";
        }
        if (cause instanceof ClosedChannelException || cause instanceof ConnectException) {
            return "nothing listens there; check the address, and that Home Assistant runs";
        }
        if (message.contains("HTTP/1.1") || message.contains("status line")) {
            return "what answers there does not speak http://; check the port, and whether it wants https://";
        }
        return message + "; check the address, and that Home Assistant runs";
    }

    /** Sends a request; the answer's failure is a {@link HomeException}. */
    CompletableFuture<JsonRecord> request(JsonObject request) {
        return request(request, event -> {});
    }

    /** As {@link #request(JsonObject)}, for a subscription, whose events {@code events} receives. */
    synchronized CompletableFuture<JsonRecord> request(JsonObject request, Consumer<JsonRecord> events) {
        CompletableFuture<JsonRecord> answer = new CompletableFuture<>();
        long id = ++last;
        answers.put(id, answer);
        subscribers.put(id, events);
        write(request.put("id", id));
        if (!isUp()) {
            answer.completeExceptionally(new HomeException(end));
        }
        return answer;
    }

    /** As {@link #request(JsonObject, Consumer)}, and waits for the answer. */
    JsonRecord ask(JsonObject request, Consumer<JsonRecord> events) throws HomeException, InterruptedException {
        return await(request(request, events), "a request");
    }

    JsonRecord ask(String type) throws HomeException, InterruptedException {
        return ask(new JsonObject().put("type", type), event -> {});
    }

    private JsonRecord await(CompletableFuture<JsonRecord> answer, String what)
            throws HomeException, InterruptedException {
        try {
            return answer.get(LIMIT.toMillis(), TimeUnit.MILLISECONDS);
        } catch (ExecutionException failure) {
            throw failure.getCause() instanceof HomeException refusal
                    ? refusal
                    : new HomeException(String.valueOf(failure.getCause()));
        } catch (TimeoutException late) {
            throw new HomeException(address + " has not answered " + what + " within " + LIMIT.toSeconds() + " s");
        }
    }

    /** Messages are sent one after another, as the client demands. */
    private synchronized void write(JsonObject message) {
        String line = message.toString();
        sent = sent.thenCompose(open -> open.sendText(line, true));
        CompletableFuture<WebSocket> unused = sent.exceptionally(failure -> {
            end("the connection to " + address + " is lost");
            return null;
        });
    }

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence part, boolean isLast) {
        text.append(part);
        if (isLast) {
            String message = text.toString();
            text.setLength(0);
            hear(message);
        }
        from.request(1);
        return null;
    }

    private void hear(String message) {
        try {
            JsonRecord said = JsonRecord.of(message);
            switch (said.text("type")) {
                case "auth_required" -> greeting.complete(said);
                case "auth_ok", REFUSED_TOKEN -> login.complete(said);
                case "result" -> answered(said);
                case "pong" -> take(said).complete(said);
                case "event" ->
                    subscribers
                            .getOrDefault(said.number("id"), event -> {})
                            .accept(said.inner("event").orElse(said));
                default -> LOG.debug("{} has sent {}", address, said.text("type"));
            }
        } catch (RuntimeException wrong) {
            LOG.warn("a message of {} could not be handled", address, wrong);
        }
    }

    private void answered(JsonRecord result) {
        CompletableFuture<JsonRecord> answer = take(result);
        if (result.truth("success")) {
            answer.complete(result);
        } else {
            JsonRecord error = result.inner("error").orElse(result);
            subscribers.remove(result.number("id"));
            answer.completeExceptionally(
                    new HomeException(error.text("code", ""), error.text("message", "it gives no reason")));
        }
    }

    private CompletableFuture<JsonRecord> take(JsonRecord said) {
        CompletableFuture<JsonRecord> answer = answers.remove(said.number("id"));
        return answer == null ? new CompletableFuture<>() : answer;
    }

    @Override
    public @Nullable CompletionStage<?> onClose(WebSocket from, int status, String why) {
        end(address + " has closed the connection");
        return null;
    }

    @Override
    public void onError(WebSocket from, Throwable failure) {
        end("the connection to " + address + " is lost: " + failure.getMessage());
    }

    private void end(String why) {
        synchronized (this) {
            if (!isUp()) {
                return;
            }
            end = why;
        }
        HomeException lost = new HomeException(why);
        greeting.completeExceptionally(lost);
        login.completeExceptionally(lost);
        answers.values().forEach(answer -> answer.completeExceptionally(lost));
        ended.countDown();
    }

    boolean isUp() {
        return end.isEmpty();
    }

    /** Why it has ended. */
    String end() {
        return end;
    }

    /** Waits for its end; false if it has not ended within the time. */
    boolean awaitEnd(Duration time) throws InterruptedException {
        return ended.await(time.toMillis(), TimeUnit.MILLISECONDS);
    }

    @Override
    public void close() {
        end("the connection to " + address + " was closed");
        WebSocket open;
        synchronized (this) {
            open = socket;
        }
        if (open != null) {
            CompletableFuture<WebSocket> unused =
                    open.sendClose(WebSocket.NORMAL_CLOSURE, "").whenComplete((done, failure) -> open.abort());
        }
    }
}
