"""What comes in: the sheet over a source, the chain traced from it, and its way into the document.

It knows documents and jobs, and nothing of the other views.
"""
