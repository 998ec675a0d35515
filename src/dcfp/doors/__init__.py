"""What a user meets: the command line and the web page. They know how to ask and how to show, and nothing of what is calculated."""
